// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check/sidecar_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr double kRelative = 1e-6, kOfModelSize = 1e-8, kAngle = 1e-4;

/// Sizes of the model by unit, from the sidecar that is trusted.
struct Sizes {
  double length = 1.0;  ///< [mm]
  double force = 1.0;   ///< [N]
};

Sizes find_sizes(const Json& sidecar) {
  Sizes sizes;
  if (const Json* camera = sidecar.find("camera")) sizes.length = camera->at("scale_mm").number();
  if (const Json* balance = sidecar.find("balance")) sizes.force = balance->at("scale_N").number();
  return sizes;
}

bool is_of_the_machine(const std::string& path) {
  constexpr std::array kKeys{"renderer", "opengl", "font", "hydroscope", "lettering_px"};
  return std::find(kKeys.begin(), kKeys.end(), path) != kKeys.end();
}

bool is_count(const std::string& path) {
  constexpr std::array kKeys{"frame",  "increment", "nodes",   "quads",          "nodes_without_value",
                             "facets", "points",    "size_px", "weighted_class", "contradicting_nodes"};
  // Of the detachment all are counts but these.
  constexpr std::array kMeasures{"least_margin", "sum_of_age_s", "sum_of_margin"};
  const std::string key = path.substr(path.rfind('.') + 1);
  if (path.starts_with("detachment."))
    return std::find(kMeasures.begin(), kMeasures.end(), key) == kMeasures.end();
  return path.starts_with("counts.") || std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

double find_tolerance(const std::string& path, double greatest, const Sizes& sizes) {
  if (is_count(path)) return 0.0;
  if (path.ends_with("_deg")) return kAngle;
  const double size = path.ends_with("_N") ? sizes.force : path.ends_with("_mm") ? sizes.length : 1.0;
  return kRelative * greatest + kOfModelSize * size;
}

std::string write_short(const Json& json) {
  std::string text = json.write();
  std::string line;
  for (const char c : text)
    if (c != '\n' && !(c == ' ' && (line.empty() || line.back() == ' ' || line.back() == '['))) line += c;
  return line.size() > 120 ? line.substr(0, 117) + "..." : line;
}

class Comparison {
 public:
  explicit Comparison(const Sizes& sizes) : sizes_(sizes) {}

  void compare(const std::string& path, const Json& expected, const Json& got);
  std::vector<std::string> take() { return std::move(differences_); }

 private:
  void compare_objects(const std::string& path, const Json& expected, const Json& got);
  bool is_like(const std::string& path, const Json& expected, const Json& got) const;

  Sizes sizes_;
  std::vector<std::string> differences_;
};

void Comparison::compare(const std::string& path, const Json& expected, const Json& got) {
  if (is_of_the_machine(path)) return;
  if (expected.is_object() && got.is_object()) {
    compare_objects(path, expected, got);
  } else if (!is_like(path, expected, got)) {
    differences_.push_back(path + ": " + write_short(got) + " instead of " + write_short(expected));
  }
}

void Comparison::compare_objects(const std::string& path, const Json& expected, const Json& got) {
  const std::string start = path.empty() ? "" : path + ".";
  for (const auto& [key, value] : expected.members()) {
    const Json* other = got.find(key);
    if (other != nullptr) {
      compare(start + key, value, *other);
    } else if (!is_of_the_machine(start + key)) {
      differences_.push_back(start + key + " is missing");
    }
  }
  for (const auto& [key, value] : got.members())
    if (expected.find(key) == nullptr && !is_of_the_machine(start + key))
      differences_.push_back(start + key + " was not there before");
}

/// The numbers of a number or of a list of numbers; null counts as not a number.
std::optional<std::vector<double>> find_numbers(const Json& json) {
  std::vector<double> numbers;
  const auto add = [&numbers](const Json& item) {
    if (!item.is_number() && !item.is_null()) return false;
    numbers.push_back(item.is_null() ? std::nan("") : item.number());
    return true;
  };
  if (!json.is_array()) return add(json) ? std::optional(numbers) : std::nullopt;
  for (const Json& item : json.items())
    if (!add(item)) return std::nullopt;
  return numbers;
}

bool Comparison::is_like(const std::string& path, const Json& expected, const Json& got) const {
  const auto a = find_numbers(expected), b = find_numbers(got);
  if (!a || !b) return expected.write() == got.write();
  if (expected.is_array() != got.is_array() || a->size() != b->size()) return false;
  double greatest = 0.0;
  for (const double number : *a)
    if (std::isfinite(number)) greatest = std::max(greatest, std::abs(number));
  const double tolerance = find_tolerance(path, greatest, sizes_);
  for (std::size_t i = 0; i < a->size(); ++i) {
    if (std::isnan((*a)[i]) && std::isnan((*b)[i])) continue;
    if (!(std::abs((*a)[i] - (*b)[i]) <= tolerance)) return false;
  }
  return true;
}

}  // namespace

std::vector<std::string> compare_sidecars(const Json& expected, const Json& got) {
  Comparison comparison(find_sizes(expected));
  comparison.compare("", expected, got);
  return comparison.take();
}

}  // namespace hydroscope
