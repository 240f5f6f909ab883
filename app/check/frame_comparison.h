// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/check/finding.h"
#include "app/results/json.h"
#include "render/class_pass.h"
#include "render/image/pixel_box.h"

namespace hydroscope {

// The limits of a check; docs/rendering_checks.md says what was measured for each.

/// On one renderer: a channel may differ by this much, and by more in this share of the
/// pixels, but never in four that form a square.
constexpr int kLevels = 3;
constexpr double kMostPixelsOff = 1e-4;
/// On another renderer: likeness of the worst window.
constexpr double kLeastLikeness = 0.7;
/// What the forces of a state may leave over, of the sum of their magnitudes. The solver's own
/// limit is 1e-3 for what is out of balance.
constexpr double kMostRest = 1e-2;
/// Nodal contact forces against the tools' own sums: rounding only.
constexpr double kMostContactError = 1e-9;
/// Nodes that no class picture shows because other walls hide them.
constexpr double kMostHiddenNodes = 5e-3;

/// How pictures are compared.
struct PictureRule {
  bool is_same_renderer = true;  ///< pixel by pixel
  bool has_same_lettering = true;
};

struct PictureVerdict {
  std::string text;            ///< why the picture is rejected, "" if it is not
  double share_off = 0.0;      ///< of the pixels; on the same renderer
  int largest_difference = 0;  ///< of a channel; on the same renderer
  double likeness = 1.0;       ///< of the worst window; on another renderer
};

/// `lettering`: boxes with text and legends, which are left out where the font is another one.
PictureVerdict compare_pictures(const Image& expected, const Image& got, const PictureRule& rule,
                                const std::vector<PixelBox>& lettering);

/// The boxes that a sidecar lists as lettering.
std::vector<PixelBox> read_lettering(const Json& sidecar);

/// Does one state add up? From the snapshot alone.
std::vector<Finding> check_balance(const Snapshot& snapshot, int frame);

/// Are the nodes drawn in their classes?
std::vector<Finding> check_classes(const ClassAgreement& agreement, int frame);

}  // namespace hydroscope
