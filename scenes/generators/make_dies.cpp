// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the tool meshes of the shipped scenes: hydroscope_make_dies FOLDER [NAME...].
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include "scenes/generators/die_meshes.h"
#include "scenes/generators/stl_file.h"
#include "solver/base/error.h"

namespace {

using namespace hydroscope;

/// One size that can be set on the command line as --KEY=VALUE; its value so far is the default.
struct Option {
  std::string key;
  std::variant<double*, int*, bool*, Coverage*> value;
  std::string what;
};

struct Dies {
  SquareDie square, job_b{20.5, 6.0, 90.0, 14, 16, 4.0, Coverage::quarter};
  SquareDie coarse = kCoarseDie;
  SquareBulgeDie bulge;
  Punch punch;
};

void list_square_options(const std::string& name, SquareDie& die, std::vector<Option>& options) {
  options.insert(options.end(), {{name + ".half-width", &die.half_width, "mm, of the cavity"},
                                 {name + ".corner-radius", &die.corner_radius, "mm"},
                                 {name + ".length", &die.length, "mm, half of it on each side of z = 0"},
                                 {name + ".corner-facets", &die.corner_facets, "in 90 degrees, even"},
                                 {name + ".flat-facets", &die.flat_facets, "along a flat, even"},
                                 {name + ".row", &die.row, "mm, facet size along z"},
                                 {name + ".coverage", &die.coverage, "full, quarter or octant"}});
}

std::vector<Option> list_options(Dies& dies) {
  std::vector<Option> options;
  list_square_options("square_die", dies.square, options);
  list_square_options("job_b_die", dies.job_b, options);
  list_square_options("coarse_die", dies.coarse, options);
  SquareBulgeDie& bulge = dies.bulge;
  const std::string name = "square_bulge_die";
  options.insert(options.end(),
                 {{name + ".guide-radius", &bulge.guide_radius, "mm, of the round ends"},
                  {name + ".half-width", &bulge.half_width, "mm, of the cavity"},
                  {name + ".corner-radius", &bulge.corner_radius, "mm, of the cavity"},
                  {name + ".square-end", &bulge.square_end, "mm, |z| where the square cavity ends"},
                  {name + ".round-start", &bulge.round_start, "mm, |z| where the round guide begins"},
                  {name + ".half-length", &bulge.half_length, "mm, |z| of the die's end"},
                  {name + ".corner-facets", &bulge.corner_facets, "in 90 degrees, even"},
                  {name + ".flat-facets", &bulge.flat_facets, "along a flat, even"},
                  {name + ".loft-rows", &bulge.loft_rows, "facets along the transition"},
                  {name + ".row", &bulge.row, "mm, largest facet along z elsewhere"},
                  {name + ".coverage", &bulge.coverage, "full, quarter or octant"},
                  {name + ".half", &bulge.is_half_length, "true: only z >= 0 and a little beyond"}});
  Punch& punch = dies.punch;
  options.insert(options.end(), {{"punch.radius", &punch.radius, "mm"},
                                 {"punch.start", &punch.start, "degrees from +x"},
                                 {"punch.end", &punch.end, "degrees from +x"},
                                 {"punch.length", &punch.length, "mm, half of it on each side of z = 0"},
                                 {"punch.facet-angle", &punch.facet_angle, "degrees, at most"},
                                 {"punch.row", &punch.row, "mm, facet size along z"}});
  return options;
}

const char* kCoverageNames[] = {"full", "quarter", "octant"};

std::string show(const Option& option) {
  char text[64];
  if (const auto* real = std::get_if<double*>(&option.value)) {
    std::snprintf(text, sizeof text, "%g", **real);
    return text;
  }
  if (const auto* whole = std::get_if<int*>(&option.value)) return std::to_string(**whole);
  if (const auto* yes = std::get_if<bool*>(&option.value)) return **yes ? "true" : "false";
  return kCoverageNames[static_cast<int>(**std::get_if<Coverage*>(&option.value))];
}

template <class Number>
bool parse(const std::string& text, Number& value) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size();
}

bool set(const Option& option, const std::string& text) {
  if (const auto* real = std::get_if<double*>(&option.value)) return parse(text, **real);
  if (const auto* whole = std::get_if<int*>(&option.value)) return parse(text, **whole);
  if (const auto* yes = std::get_if<bool*>(&option.value)) {
    **yes = text == "true";
    return text == "true" || text == "false";
  }
  for (int i = 0; i < 3; ++i) {
    if (text != kCoverageNames[i]) continue;
    **std::get_if<Coverage*>(&option.value) = static_cast<Coverage>(i);
    return true;
  }
  return false;
}

void print_help(const std::vector<Option>& options) {
  std::printf(
      "Usage: hydroscope_make_dies FOLDER [NAME...] [--text] [--NAME.OPTION=VALUE...]\n"
      "Writes FOLDER/NAME.stl [mm] for each NAME: square_die, square_bulge_die, punch, job_b_die, "
      "coarse_die\n"
      "(all of them by default). Binary STL, or text with --text.\n\nOptions and their defaults:\n");
  for (const Option& option : options) {
    const std::string left = "--" + option.key + "=" + show(option);
    std::printf("  %-40s %s\n", left.c_str(), option.what.c_str());
  }
}

void apply(const std::vector<Option>& options, const std::string& argument) {
  const std::size_t equal = argument.find('=');
  const std::string key = argument.substr(2, equal == std::string::npos ? equal : equal - 2);
  for (const Option& option : options) {
    if (option.key != key) continue;
    if (equal != std::string::npos && set(option, argument.substr(equal + 1))) return;
    throw InputError(argument + ": expected --" + key + "=VALUE, " + option.what);
  }
  throw InputError(argument + ": no such option, see --help");
}

int run(const std::vector<std::string>& arguments) {
  Dies dies;
  const std::vector<Option> options = list_options(dies);
  const std::vector<std::pair<std::string, std::function<TriangleMesh()>>> makers = {
      {"square_die", [&] { return make_square_die(dies.square); }},
      {"square_bulge_die", [&] { return make_square_bulge_die(dies.bulge); }},
      {"punch", [&] { return make_punch(dies.punch); }},
      {"job_b_die", [&] { return make_square_die(dies.job_b); }},
      {"coarse_die", [&] { return make_square_die(dies.coarse); }}};
  std::vector<std::string> words;
  bool is_text = false;
  for (const std::string& argument : arguments) {
    if (argument == "--help" || argument == "-h") {
      print_help(options);
      return 0;
    }
    if (argument == "--text") {
      is_text = true;
    } else if (argument.rfind("--", 0) == 0) {
      apply(options, argument);
    } else {
      words.push_back(argument);
    }
  }
  if (words.empty()) throw InputError("no FOLDER given, see --help");
  for (std::size_t i = 1; i < words.size(); ++i) {
    bool is_known = false;
    for (const auto& maker : makers) is_known = is_known || maker.first == words[i];
    if (!is_known) throw InputError(words[i] + ": no such die, see --help");
  }
  std::error_code code;
  std::filesystem::create_directories(words[0], code);
  if (code) throw EnvironmentError(words[0] + ": " + code.message());
  for (const auto& [name, make] : makers) {
    bool is_wanted = words.size() == 1;
    for (std::size_t i = 1; i < words.size(); ++i) is_wanted = is_wanted || words[i] == name;
    if (!is_wanted) continue;
    const TriangleMesh mesh = make();
    const std::string path = words[0] + "/" + name + ".stl";
    write_file(path, is_text ? make_text_stl(mesh, name) : make_binary_stl(mesh, name));
    std::printf("%s: %zu facets\n", path.c_str(), mesh.triangles.size());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const hydroscope::InputError& error) {
    std::fprintf(stderr, "hydroscope_make_dies: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hydroscope_make_dies: %s\n", error.what());
    return 5;
  }
}
