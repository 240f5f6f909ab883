// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/machine.h"

#include <sched.h>
#include <sys/utsname.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>

namespace hydroscope {
namespace {

/// What follows `key` and one separator on the first line that begins with it.
std::string find_line(const std::string& file, const std::string& key, char separator) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(key, 0) != 0) continue;
    std::string value = line.substr(line.find(separator) + 1);
    std::erase(value, '"');
    const std::size_t first = value.find_first_not_of(" \t");
    return first == std::string::npos ? "" : value.substr(first);
  }
  return "unknown";
}

int count_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

}  // namespace

Machine find_machine() {
  Machine machine;
  machine.processor = find_line("/proc/cpuinfo", "model name", ':');
  machine.cores = count_cores();
  machine.memory_gb = std::atof(find_line("/proc/meminfo", "MemTotal", ':').c_str()) / 1024.0 / 1024.0;
  machine.system = find_line("/etc/os-release", "PRETTY_NAME", '=');
  utsname name{};
  if (uname(&name) == 0)
    machine.system += std::string(", ") + name.sysname + " " + name.release + " " + name.machine;
  const std::time_t now = std::time(nullptr);
  std::array<char, 40> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", std::gmtime(&now));
  machine.date = text.data();
  return machine;
}

}  // namespace hydroscope
