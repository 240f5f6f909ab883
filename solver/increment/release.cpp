// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/release.h"

#include <algorithm>
#include <cmath>

namespace hydroscope {

namespace {

// Tension as large as the fluid's share of the node is no noise, whatever the neighbours carry.
constexpr double kCertainTension = 1.0;
constexpr double kPatchShare = 0.05;  // of the nodes in contact under tension: a patch lets go, not noise

struct PatchScale {
  double mean_force = 0.0;  ///< of the nodes pressed by this tool [N]
  int count = 0;            ///< nodes in contact with it
};

PatchScale calc_patch_scale(const std::vector<ContactPoint>& contacts) {
  PatchScale scale;
  int pressed = 0;
  for (const ContactPoint& c : contacts) {
    if (!c.is_active()) continue;
    ++scale.count;
    if (c.normal_force <= 0.0) continue;
    scale.mean_force += c.normal_force;
    ++pressed;
  }
  if (pressed > 0) scale.mean_force /= pressed;
  return scale;
}

/// Looks at the nodes of one tool.
class TensionTest {
 public:
  TensionTest(const Model& model, const Loads& loads, std::size_t tool, const Trial& trial)
      : model_(model),
        trial_(trial),
        contacts_(trial.contacts[tool]),
        pressure_(std::abs(loads.pressure)),
        scale_(calc_patch_scale(contacts_)) {}

  const PatchScale& scale() const { return scale_; }

  /// Figures of a node, with `share` of the tolerance as its threshold.
  Release measure(std::size_t i, double share, ReleaseCause cause) const {
    const double reference = std::max(pressure_ * trial_.area[i], 0.1 * scale_.mean_force);
    return {cause, contacts_[i].normal_force,
            calc_smoothed_pressure(model_, contacts_, trial_.area, static_cast<int>(i)),
            share * model_.contact.release_tolerance * reference};
  }

  bool is_pulled(std::size_t i, const Release& figures, double share) const {
    const double reference = std::max(pressure_ * trial_.area[i], 0.1 * scale_.mean_force);
    if (figures.force < -kCertainTension * reference) return true;
    return contacts_[i].locked == 0 &&
           figures.force < -share * model_.contact.release_tolerance * reference && figures.pressure <= 0.0;
  }

 private:
  const Model& model_;
  const Trial& trial_;
  const std::vector<ContactPoint>& contacts_;
  double pressure_;
  PatchScale scale_;
};

}  // namespace

void set_free(ContactPoint& point, const Release& release) {
  if (point.is_active()) point.release = release;
  point.status = ContactStatus::kFree;
  point.normal_force = 0.0;
  point.friction.setZero();
}

double calc_smoothed_pressure(const Model& model, const std::vector<ContactPoint>& contacts,
                              const std::vector<double>& area, int node) {
  const auto i = static_cast<std::size_t>(node);
  double force = contacts[i].normal_force, sum = area[i];
  for (const int j : model.node_neighbours[i]) {
    const auto k = static_cast<std::size_t>(j);
    if (!contacts[k].is_active()) continue;
    force += 0.5 * contacts[k].normal_force;
    sum += 0.5 * area[k];
  }
  return sum > 0.0 ? force / sum : 0.0;
}

std::vector<NodeRelease> find_releases(const Model& model, const Loads& loads, std::size_t tool,
                                       const Trial& trial) {
  const auto& contacts = trial.contacts[tool];
  const TensionTest test(model, loads, tool, trial);
  std::vector<NodeRelease> releases;
  std::vector<char> is_released(contacts.size(), 0);
  const auto look_at = [&](std::size_t i, double share, ReleaseCause cause) {
    const Release figures = test.measure(i, share, cause);
    if (cause != ReleaseCause::kEdge && !test.is_pulled(i, figures, share)) return;
    is_released[i] = 1;
    releases.push_back({i, figures});
  };
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!contacts[i].is_active()) continue;
    const bool has_left_edge = contacts[i].foot.beyond_edge > 0.5 * model.thickness;
    look_at(i, 1.0, has_left_edge ? ReleaseCause::kEdge : ReleaseCause::kTension);
  }
  const bool is_patch = kPatchShare * test.scale().count <= static_cast<double>(releases.size());
  for (std::size_t k = 0; is_patch && k < releases.size(); ++k) {
    for (const int neighbour : model.node_neighbours[releases[k].node]) {
      const auto j = static_cast<std::size_t>(neighbour);
      if (is_released[j] == 0 && contacts[j].is_active()) look_at(j, 0.25, ReleaseCause::kPatch);
    }
  }
  return releases;
}

bool release_by_sign(const Model& model, const Loads& loads, const std::vector<NodeBasis>& bases,
                     Trial& trial) {
  bool any = false;
  for (std::size_t t = 0; t < model.tools.size(); ++t) {
    for (std::size_t i = 0; i < trial.contacts[t].size(); ++i) {
      ContactPoint& point = trial.contacts[t][i];
      if (!point.is_active() || point.held_row < 0) continue;
      double force = point.normal_force;
      if (model.release == ReleaseRule::kSign) {  // n . f_int: the fluid's share stays in it
        const auto at = static_cast<Eigen::Index>(kDofs * i);
        force += loads.pressure *
                 bases[i].transform().col(point.held_row).dot(trial.pressure_load.segment<kDofs>(at));
      }
      if (force >= 0.0) continue;
      set_free(point,
               {ReleaseCause::kSign, force,
                calc_smoothed_pressure(model, trial.contacts[t], trial.area, static_cast<int>(i)), 0.0});
      any = true;
    }
  }
  return any;
}

}  // namespace hydroscope
