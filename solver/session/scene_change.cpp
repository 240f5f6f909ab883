// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/scene_change.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "solver/base/error.h"
#include "solver/scene/key_suggestion.h"
#include "solver/scene/number_text.h"
#include "solver/scene/scene_reader.h"
#include "solver/scene/scene_table.h"
#include "solver/session/accuracy_choices.h"
#include "solver/session/build_model.h"

namespace hydroscope {

namespace {

using Rows = std::vector<std::vector<double>>;

std::string join(const std::vector<std::string>& items) {
  std::string joined;
  for (const std::string& item : items) joined += (joined.empty() ? "" : ", ") + item;
  return joined;
}

/// Where a full key keeps its value; the scene has it.
SceneSlot find_slot(Scene& scene, const std::string& key) {
  const std::size_t first = key.find('.'), last = key.rfind('.');
  const SceneTable* table = find_scene_table(key.substr(0, first));
  const std::string name = last > first ? key.substr(first + 1, last - first - 1) : std::string();
  return table->find(key.substr(last + 1))->slot(scene, name);
}

/// The rows of a path, time first; nothing where the key is none.
struct ReadRows {
  Rows rows;
  bool is_path = false;

  void operator()(const Path* path) {
    is_path = true;
    for (std::size_t i = 0; i < path->times.size(); ++i) rows.push_back({path->times[i], path->values[i]});
  }
  void operator()(const std::vector<std::array<double, 4>>* motion) {
    is_path = true;
    for (const auto& row : *motion) rows.emplace_back(row.begin(), row.end());
  }
  template <class Other>
  void operator()(const Other* /*value*/) {}
};

ReadRows read_rows(const Scene& scene, const std::string& key) {
  Scene copy = scene;  // slots are for writing
  ReadRows read;
  std::visit([&read](auto* slot) { read(slot); }, find_slot(copy, key));
  return read;
}

/// All columns but the time, as a Path gives them.
std::vector<double> interpolate(const Rows& rows, double time, std::size_t columns) {
  std::vector<double> values(columns, 0.0);
  for (std::size_t c = 0; c < columns; ++c) {
    Path path;
    for (const auto& row : rows) {
      path.times.push_back(row[0]);
      path.values.push_back(row[c + 1]);
    }
    values[c] = path(time);
  }
  return values;
}

std::string to_text(const std::vector<double>& numbers) {
  std::vector<std::string> texts;
  for (const double number : numbers) texts.push_back(format_exact(number));
  return "[" + join(texts) + "]";
}

std::string to_text(const Rows& rows) {
  std::vector<std::string> texts;
  for (const auto& row : rows) texts.push_back(to_text(row));
  return "[" + join(texts) + "]";
}

/// One change on its way.
class Change {
 public:
  Change(const ChangeContext& context, const std::string& key, const std::string& value)
      : context_(context), now_(context.state.time), key_(key), shown_("set " + key + " " + value) {
    check_key();
    for (const SceneOverride& item : context.setup.overrides) {
      if (item.key != key) overrides_.push_back(item);
    }
    overrides_.push_back({key, value, shown_});
  }

  SceneChange make() {
    Scene scene = parse();
    const ReadRows wanted = read_rows(scene, key_);
    if (wanted.is_path) {
      overrides_.back().value = to_text(go_on(read_rows(context_.setup.scene, key_).rows, wanted.rows));
      scene = parse();
    }
    check_leaving(scene);
    auto setup = std::make_shared<RunSetup>();
    setup->scene = choose_for_accuracy(scene);
    setup->overrides = overrides_;
    setup->model = build_model(setup->scene);
    check_structure(setup->model);
    for (std::size_t t = 0; t < setup->model.tools.size(); ++t)
      setup->model.tools[t].surface = context_.setup.model.tools[t].surface;
    return {std::move(setup), wanted.is_path};
  }

 private:
  [[noreturn]] void fail(const std::string& text) const {
    throw InputError(shown_ + ": key '" + key_ + "': " + text);
  }

  void check_key() const {
    const std::vector<std::string> keys = settable_keys(context_.setup.scene);
    if (std::find(keys.begin(), keys.end(), key_) != keys.end()) return;
    const std::string nearest = find_nearest_name(key_, keys);
    fail("cannot be changed while the run goes on; " +
         (nearest.empty() ? std::string() : "did you mean '" + nearest + "'? ") +
         "what may be changed: " + join(keys));
  }

  Scene parse() const { return parse_scene(context_.source, context_.setup.scene.file, overrides_, true); }

  /// The old path up to now, the present value, and what is wanted from now on.
  Rows go_on(const Rows& old, const Rows& wanted) const {
    const std::size_t columns = wanted.front().size() - 1;
    const std::vector<double> value = interpolate(old, now_, columns);
    if (wanted.front()[0] <= now_) check_value(value, interpolate(wanted, now_, columns), wanted);
    Rows rows;
    for (const auto& row : old) {
      if (row[0] < now_) rows.push_back(row);
    }
    rows.push_back(value);
    rows.back().insert(rows.back().begin(), now_);
    const std::size_t behind = rows.size();
    for (const auto& row : wanted) {
      if (row[0] > now_) rows.push_back(row);
    }
    if (rows.size() == behind) fail("has no point ahead of the present time, " + format_exact(now_) + " s");
    return rows;
  }

  void check_value(const std::vector<double>& present, const std::vector<double>& wanted,
                   const Rows& rows) const {
    constexpr double kJump = 1e-6;  // of the largest value
    double largest = 0.0;
    for (const auto& row : rows) {
      for (std::size_t c = 1; c < row.size(); ++c) largest = std::max(largest, std::abs(row[c]));
    }
    for (std::size_t c = 0; c < present.size(); ++c) {
      if (std::abs(wanted[c] - present[c]) <= kJump * largest) continue;
      std::vector<double> point = present;
      point.insert(point.begin(), now_);
      fail("would jump from " + to_text(present) + " to " + to_text(wanted) + " at the present time, " +
           format_exact(now_) + " s; expected a path through " + to_text(point) +
           ", or one that begins later: it then goes on from the present value");
    }
  }

  /// A tool is taken away ahead, and one that is gone does not come back.
  void check_leaving(const Scene& scene) const {
    for (const auto& [name, tool] : scene.tools) {
      if (key_ != "tool." + name + ".leaves_at_s") continue;
      const auto& before = context_.setup.scene.tools.at(name).leaves_at;
      if (before && *before <= now_) fail("the tool has left at " + format_exact(*before) + " s");
      if (*tool.leaves_at <= now_)
        fail(format_exact(*tool.leaves_at) + " is over; the present time is " + format_exact(now_) + " s");
    }
  }

  /// Whatever a state refers to must be as it was.
  void check_structure(const Model& model) const {
    const Model& old = context_.setup.model;
    const auto same_supports = [](const std::vector<Support>& a, const std::vector<Support>& b) {
      return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Support& s, const Support& t) {
        return s.kind == t.kind && s.direction == t.direction && s.motion == t.motion;
      });
    };
    const bool is_same =
        model.x0 == old.x0 && model.quads == old.quads && model.thickness == old.thickness &&
        model.tools.size() == old.tools.size() && model.law.rule.size() == old.law.rule.size() &&
        model.motions.size() == old.motions.size() && model.edge_loads.size() == old.edge_loads.size() &&
        std::equal(model.supports.begin(), model.supports.end(), old.supports.begin(), old.supports.end(),
                   same_supports);
    if (!is_same) fail("would change mesh, supports or loads as such, which a run cannot do on its way");
  }

  const ChangeContext& context_;
  double now_;
  std::string key_, shown_;
  std::vector<SceneOverride> overrides_;
};

}  // namespace

std::vector<std::string> settable_keys(const Scene& scene) {
  std::vector<std::string> keys = {"load.axial_feed_mm"};
  keys.insert(keys.begin(), scene.load.control == "volume" ? "load.volume_ratio" : "load.pressure_MPa");
  for (const auto& [name, tool] : scene.tools) {
    for (const char* key : {"friction", "motion_mm", "leaves_at_s"})
      keys.push_back("tool." + name + "." + key);
  }
  for (const auto& [which, edge] : scene.edges) {
    const std::vector<std::pair<const char*, const Path*>> paths = {
        {"move_x_mm", &edge.move_x},         {"move_y_mm", &edge.move_y},
        {"force_x_N_per_mm", &edge.force_x}, {"force_y_N_per_mm", &edge.force_y},
        {"tension_N_per_mm", &edge.tension}, {"moment_N", &edge.moment}};
    for (const auto& [key, path] : paths) {
      if (!path->empty()) keys.push_back("edge." + which + "." + key);
    }
  }
  const std::set<std::string> fixed = {"initial_s", "correction", "control", "r_safe", "algoneq_passes"};
  for (const char* table : {"increment", "limits", "stop"}) {
    for (const std::string& key : find_scene_table(table)->key_names()) {
      if (fixed.count(key) == 0) keys.push_back(std::string(table) + "." + key);
    }
  }
  for (const char* key : {"contact.tolerance_mm", "contact.release_tolerance", "states.number"})
    keys.emplace_back(key);
  return keys;
}

SceneChange change_ahead(const ChangeContext& context, const std::string& key, const std::string& value) {
  return Change(context, key, value).make();
}

}  // namespace hydroscope
