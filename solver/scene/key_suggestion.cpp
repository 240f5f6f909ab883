// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/key_suggestion.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace hydroscope {
namespace {

// Ours, and those that people write by habit. Longer ones first: `_N_per_mm` ends in `_mm`.
constexpr std::array kUnits = {
    "_N_per_mm", "_kN_per_mm", "_radians", "_degrees", "_seconds", "_pixels", "_inch", "_deg", "_rad",
    "_bar",      "_GPa",       "_MPa",     "_kPa",     "_psi",     "_mm",     "_cm",   "_um",  "_ms",
    "_px",       "_in",        "_Pa",      "_kN",      "_s",       "_m",      "_N"};

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool ends_with_any_case(const std::string& text, const std::string& end) {
  if (text.size() <= end.size()) return false;
  return std::equal(end.rbegin(), end.rend(), text.rbegin(),
                    [](char a, char b) { return lower(a) == lower(b); });
}

}  // namespace

int calc_edit_distance(const std::string& a, const std::string& b) {
  const size_t rows = a.size() + 1, columns = b.size() + 1;
  std::vector<std::vector<int>> d(rows, std::vector<int>(columns, 0));
  for (size_t i = 0; i < rows; ++i) d[i][0] = static_cast<int>(i);
  for (size_t j = 0; j < columns; ++j) d[0][j] = static_cast<int>(j);
  for (size_t i = 1; i < rows; ++i) {
    for (size_t j = 1; j < columns; ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same ? 0 : 1)});
      const bool swapped =
          i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[rows - 1][columns - 1];
}

std::string strip_unit(const std::string& key) {
  for (const std::string unit : kUnits) {
    if (ends_with_any_case(key, unit)) return key.substr(0, key.size() - unit.size());
  }
  return key;
}

std::string find_nearest_name(const std::string& given, const std::vector<std::string>& known) {
  const std::string stem = strip_unit(given);
  for (const std::string& name : known) {
    if (calc_edit_distance(strip_unit(name), stem) == 0) return name;
  }
  std::string nearest;
  // A third of the letters may differ: more than that is another word.
  int best = std::max(2, static_cast<int>(given.size()) / 3) + 1;
  for (const std::string& name : known) {
    const std::string name_stem = strip_unit(name);
    const int distance = std::min(calc_edit_distance(name, given), calc_edit_distance(name_stem, stem));
    const bool shares_letters = distance < static_cast<int>(std::min(stem.size(), name_stem.size()));
    if (distance < best && shares_letters) {
      best = distance;
      nearest = name;
    }
  }
  return nearest;
}

}  // namespace hydroscope
