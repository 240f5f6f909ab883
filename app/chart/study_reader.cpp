// SPDX-License-Identifier: GPL-3.0-or-later
// From the text of a study to its values; study_checks.cpp looks at what they name.
#include <algorithm>
#include <map>

#include "app/chart/closed_forms.h"
#include "app/chart/study.h"
#include "app/chart/study_checks.h"
#include "app/chart/study_entry.h"
#include "app/chart/study_keys.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : folder_(file.parent_path()) {
    study_.file = file.string();
  }

  Study read(const SceneSource& source) {
    for (const StudyItem& item : sort_study_items(source)) read_item(item);
    return std::move(study_);
  }

 private:
  void read_item(const StudyItem& item);
  void read_case(const StudyItem& item);
  void read_case_part(const StudyItem& item, StudyCase& one);
  void read_axis(const StudyItem& item, StudyCase& one);
  void read_quantity(const SourceEntry& entry, StudyQuantity& quantity);
  void read_plot(const SourceEntry& entry, StudyPlot& plot);
  void read_setting(const StudyItem& item, StudySetting& setting, std::size_t depth,
                    const std::string& table);
  std::string locate(const std::string& file) const { return (folder_ / file).lexically_normal().string(); }

  std::filesystem::path folder_;
  Study study_;
};

void Reader::read_item(const StudyItem& item) {
  const StudyPath& path = item.path();
  const std::vector<std::string> tables = {"run", "case", "plot"};
  if (path.size() == 1 && item.entry != nullptr)
    return set_study_key(*item.entry, "the top of the file", {{"title", to(study_.title)}});
  if (std::find(tables.begin(), tables.end(), path[0]) == tables.end())
    fail_unknown(item.where(), "table", path[0], tables);
  if (path[0] == "case") return read_case(item);
  if (path[0] == "plot" && path.size() >= 2) {
    StudyPlot& plot = find_or_add(study_.plots, path[1], item.where());
    if (path.size() > 3 || (path.size() == 3 && item.entry == nullptr))
      fail_unknown(item.where(), "table in [plot." + path[1] + "]", path[2], {});
    if (item.entry != nullptr && path.size() == 3) read_plot(*item.entry, plot);
    return;
  }
  if (item.entry == nullptr) return;
  if (path[0] == "plot")
    throw InputError(item.where() + ": [plot.NAME] expected, with a name of your choice");
  set_study_key(
      *item.entry, "[run]",
      {{"jobs", [this](const StudyEntry& e) { study_.jobs = e.whole_number(0, 256); }},
       {"repeats", [this](const StudyEntry& e) { study_.repeats = e.whole_number(1, 99); }},
       {"threads", [this](const StudyEntry& e) { study_.threads = e.whole_number(1, 64); }},
       {"finest_time_limit_s",
        [this](const StudyEntry& e) { study_.finest_time_limit = e.number(0.01, 1e6); }},
       {"timed_once_from_s", [this](const StudyEntry& e) { study_.timed_once_from = e.number(0.0, 1e6); }},
       {"time_limit_s", [this](const StudyEntry& e) { study_.time_limit = e.number(0.01, 1e6); }}});
}

void Reader::read_case(const StudyItem& item) {
  const StudyPath& path = item.path();
  if (path.size() < 2) return;
  if (path.size() == 2 && item.entry != nullptr)
    throw InputError(item.where() + ": [case.NAME] expected, with a name of your choice");
  StudyCase& one = find_or_add(study_.cases, path[1], item.where());
  if (path.size() == 2) return;
  const std::vector<std::string> parts = {"set",       "finest",  "axis",        "variant", "quantity",
                                          "elsewhere", "history", "convergence", "profile"};
  if (std::find(parts.begin(), parts.end(), path[2]) != parts.end()) return read_case_part(item, one);
  const std::string table = "[case." + path[1] + "]";
  if (item.entry == nullptr || path.size() > 3)
    fail_unknown(item.where(), "table in " + table, path[2], parts);
  set_study_key(*item.entry, table,
                {{"title", to(one.title)},
                 {"scene",
                  [&](const StudyEntry& e) {
                    one.scene = locate(e.text());
                    one.scene_where = e.where();
                  }},
                 {"default", to(one.standard)},
                 {"timed", to(one.is_timed)},
                 {"error",
                  [&](const StudyEntry& e) {
                    one.is_rms = e.one_of({"max", "rms"}) == "rms";
                  }},
                 {"without", to(one.without)}});
}

void Reader::read_setting(const StudyItem& item, StudySetting& setting, std::size_t depth,
                          const std::string& table) {
  if (item.entry == nullptr) return;
  const StudyPath& path = item.path();
  if (path.size() > depth + 1 && path[depth] == "set")
    return setting.overrides.push_back(make_scene_override(*item.entry, depth + 1));
  if (path.size() == depth + 1) return set_study_key(*item.entry, table, {{"label", to(setting.label)}});
  fail_unknown(item.where(), "table in " + table, path[depth], {"set"});
}

void Reader::read_axis(const StudyItem& item, StudyCase& one) {
  const StudyPath& path = item.path();
  StudyAxis& axis = find_or_add(one.axes, path[3], item.where());
  const std::string table = "[case." + path[1] + ".axis." + path[3] + "]";
  if (path.size() >= 6 && path[4] == "point") {
    StudySetting& setting = find_or_add(axis.settings, path[5], item.where());
    if (item.entry != nullptr && path.size() == 6) StudyEntry(*item.entry).fail("a table of scene keys");
    if (item.entry != nullptr) setting.overrides.push_back(make_scene_override(*item.entry, 6));
    return;
  }
  if (path.size() == 5 && path[4] == "point" && item.entry == nullptr) return;
  if (path.size() == 4) return;
  if (item.entry == nullptr || path.size() > 5)
    fail_unknown(item.where(), "table in " + table, path[4], {"point"});
  static const std::string kNoKey = "'key' before 'values': the scene key that they are given to";
  set_study_key(
      *item.entry, table,
      {{"label", to(axis.label)},
       {"key",
        [&](const StudyEntry& e) {
          axis.settings = {{"", "", e.where(), {{e.text(), "", ""}}, {}}};
        }},
       {"size",
        [&](const StudyEntry& e) {
          axis.is_inverse = e.one_of({"value", "inverse"}) == "inverse";
        }},
       {"values", [&](const StudyEntry& e) {
          if (axis.settings.size() != 1 || !axis.settings[0].name.empty())
            throw InputError(e.where() + ": " + kNoKey + " expected");
          const std::string key = axis.settings[0].overrides[0].key;
          axis.settings.clear();
          for (const SourceValue& value : e.list()) {
            const std::string written = write_toml(value);
            const auto* text = std::get_if<std::string>(&value.value);
            const std::string name = text != nullptr ? *text : written;
            StudySetting setting{
                name, name, e.where(), {{key, written, e.where() + ": " + key + " = " + written}}, {}};
            if (const auto* real = std::get_if<double>(&value.value)) setting.size = *real;
            if (const auto* whole = std::get_if<std::int64_t>(&value.value))
              setting.size = static_cast<double>(*whole);
            axis.settings.push_back(setting);
          }
        }}});
}

void Reader::read_quantity(const SourceEntry& entry, StudyQuantity& quantity) {
  const std::map<std::string, StudyQuantity::Reference> kinds = {
      {"formula", StudyQuantity::Reference::kFormula},
      {"table", StudyQuantity::Reference::kTable},
      {"finest", StudyQuantity::Reference::kFinest}};
  set_study_key(entry, "[case.NAME.quantity." + quantity.name + "]",
                {{"label", to(quantity.label)},
                 {"column", to(quantity.column)},
                 {"driver", to(quantity.driver)},
                 {"at", to(quantity.at)},
                 {"reference",
                  [&](const StudyEntry& e) {
                    quantity.reference = kinds.at(e.one_of({"formula", "table", "finest"}));
                  }},
                 {"formula", [&](const StudyEntry& e) { quantity.formula = e.one_of(closed_form_names()); }},
                 {"values", to(quantity.values)},
                 {"source", to(quantity.source)},
                 {"scale", [&](const StudyEntry& e) { quantity.scale = e.number(1e-300, 1e300); }}});
}

void Reader::read_case_part(const StudyItem& item, StudyCase& one) {
  const StudyPath& path = item.path();
  const std::string &part = path[2],
                    table = "[case." + path[1] + "." + part + (path.size() > 3 ? "." + path[3] : "") + "]";
  if (part == "set") {
    if (item.entry != nullptr && path.size() > 3) one.set.push_back(make_scene_override(*item.entry, 3));
    return;
  }
  if (part == "finest") {
    if (!one.finest) one.finest = StudySetting{"finest", "finest run", item.where(), {}, {}};
    if (path.size() > 3) read_setting(item, *one.finest, 3, table);
    return;
  }
  if (path.size() == 3 && item.entry == nullptr) return;
  if (path.size() == 3 || (path.size() == 4 && item.entry != nullptr))
    throw InputError(item.where() + ": [case." + path[1] + "." + part +
                     ".NAME] expected, with a name of your choice");
  if (part == "axis") return read_axis(item, one);
  if (part == "variant")
    return read_setting(item, find_or_add(one.variants, path[3], item.where()), 4, table);
  if (path.size() > 5 || (path.size() == 5 && item.entry == nullptr))
    fail_unknown(item.where(), "table in " + table, path[4], {});
  const auto set = [&](const KeySetters& setters) {
    if (item.entry != nullptr) set_study_key(*item.entry, table, setters);
  };
  if (part == "quantity") {
    StudyQuantity& quantity = find_or_add(one.quantities, path[3], item.where());
    if (item.entry != nullptr) read_quantity(*item.entry, quantity);
  } else if (part == "elsewhere") {
    StudyElsewhere& point = find_or_add(one.elsewhere, path[3], item.where());
    set({{"label", to(point.label)},
         {"note", to(point.note)},
         {"error_percent", to(point.error_percent)},
         {"wall_s", to(point.wall_s)},
         {"factorisations", to(point.factorisations)}});
  } else if (part == "history") {
    StudyHistory& history = find_or_add(one.histories, path[3], item.where());
    set({{"title", to(history.title)},
         {"x", to(history.x)},
         {"columns", to(history.columns)},
         {"runs", to(history.runs)},
         {"log", to(history.is_log)}});
  } else if (part == "convergence") {
    StudyConvergence& convergence = find_or_add(one.convergences, path[3], item.where());
    set({{"title", to(convergence.title)}, {"axis", to(convergence.axis)}});
  } else {
    StudyProfile& profile = find_or_add(one.profiles, path[3], item.where());
    set({{"title", to(profile.title)},
         {"runs", to(profile.runs)},
         {"at_pressure_MPa", to(profile.at_pressure)},
         {"formula", [&](const StudyEntry& e) { profile.formula = e.one_of(profile_form_names()); }},
         {"driver", to(profile.driver)}});
  }
}

void Reader::read_plot(const SourceEntry& entry, StudyPlot& plot) {
  set_study_key(entry, "[plot." + plot.name + "]",
                {{"title", to(plot.title)},
                 {"file", [&](const StudyEntry& e) { plot.file = locate(e.text()); }},
                 {"x", to(plot.x)},
                 {"y", to(plot.y)},
                 {"x_title", to(plot.x_title)},
                 {"y_title", to(plot.y_title)},
                 {"x_log", to(plot.is_x_log)},
                 {"y_log", to(plot.is_y_log)},
                 {"slope", to(plot.slope)}});
}

}  // namespace

Study parse_study(const std::string& text, const std::filesystem::path& file) {
  const SceneSource source = parse_scene_source(text, file.string(), {});
  Study study = Reader(file).read(source);
  check_study(study);
  return study;
}

Study read_study(const std::filesystem::path& file) {
  Study study = parse_study(read_whole_file(file), file);
  check_study_scenes(study);
  return study;
}

}  // namespace hydroscope
