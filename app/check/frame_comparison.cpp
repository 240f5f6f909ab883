// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check/frame_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "render/force_balance.h"
#include "render/image/image_difference.h"

namespace hydroscope {
namespace {

template <class... Values>
std::string print(const char* form, Values... values) {
  std::array<char, 240> text{};
  std::snprintf(text.data(), text.size(), form, values...);
  return text.data();
}

std::string describe_size(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

PictureVerdict compare_pixels(const Image& expected, const Image& got,
                              const std::vector<PixelBox>& left_out) {
  const PixelDifference d = calc_pixel_difference(expected, got, kLevels, left_out);
  PictureVerdict verdict{"", d.share(), d.largest, 1.0};
  if (!d.has_block && d.share() <= kMostPixelsOff) return verdict;
  verdict.text =
      print("%d pixels (%.3g %%) differ by more than %d levels, the most by %d%s at (%d, %d)", d.off,
            100.0 * d.share(), kLevels, d.largest, d.has_block ? "; a block of 2 x 2" : "", d.x, d.y);
  return verdict;
}

PictureVerdict compare_structure(const Image& expected, const Image& got,
                                 const std::vector<PixelBox>& left_out) {
  const StructureDifference d = calc_structure_difference(expected, got, left_out);
  PictureVerdict verdict{"", 0.0, 0, d.worst};
  if (d.worst >= kLeastLikeness) return verdict;
  verdict.text =
      print("likeness %.3f in the window of %d x %d pixels at (%d, %d); at least %.2f on another renderer",
            d.worst, kWindow, kWindow, d.x, d.y, kLeastLikeness);
  return verdict;
}

std::string list_nodes(const std::vector<int>& nodes) {
  std::string list;
  for (std::size_t i = 0; i < nodes.size() && i < 10; ++i)
    list += (i > 0 ? ", " : "") + std::to_string(nodes[i]);
  return nodes.size() > 10 ? list + ", ..." : list;
}

}  // namespace

PictureVerdict compare_pictures(const Image& expected, const Image& got, const PictureRule& rule,
                                const std::vector<PixelBox>& lettering) {
  if (expected.width != got.width || expected.height != got.height)
    return {.text = describe_size(got) + " pixels instead of " + describe_size(expected)};
  if (is_blank(got, lettering) && !is_blank(expected, lettering)) return {.text = "the picture is blank"};
  const std::vector<PixelBox> left_out = rule.has_same_lettering ? std::vector<PixelBox>{} : lettering;
  return rule.is_same_renderer ? compare_pixels(expected, got, left_out)
                               : compare_structure(expected, got, left_out);
}

std::vector<PixelBox> read_lettering(const Json& sidecar) {
  std::vector<PixelBox> boxes;
  const Json* list = sidecar.find("lettering_px");
  if (list == nullptr) return boxes;
  const Json::Array& items = list->items();
  for (std::size_t i = 0; i + 3 < items.size(); i += 4) {
    const auto at = [&](std::size_t k) { return static_cast<int>(std::lround(items[i + k].number())); };
    boxes.push_back({at(0), at(1), at(2), at(3)});
  }
  return boxes;
}

std::vector<Finding> check_balance(const Snapshot& snapshot, int frame) {
  std::vector<Finding> findings;
  const auto add = [&](const std::string& text) {
    findings.push_back({CheckStage::kBalance, "", frame, text});
  };
  const ForceBalance balance = calc_force_balance(snapshot);
  if (balance.contact_error_share() > kMostContactError)
    add(print("the nodes' contact forces and the tools' own sums differ by %.4g N", balance.contact_error));
  if (balance.rest_share() > kMostRest)
    add(print("pressure, contact and supports leave %.4g N over, %.3g %% of their sum", balance.rest.norm(),
              100.0 * balance.rest_share()));
  if (balance.contradicting_nodes > 0)
    add(std::to_string(balance.contradicting_nodes) +
        " nodes are free with a contact force, or touch without a tool");
  return findings;
}

std::vector<Finding> check_classes(const ClassAgreement& agreement, int frame) {
  std::vector<Finding> findings;
  const auto add = [&](const std::string& text) {
    findings.push_back({CheckStage::kClasses, "", frame, text});
  };
  if (agreement.is_blank()) {
    add("nothing of the sheet is drawn");
    return findings;
  }
  for (std::size_t c = 0; c < agreement.drawn.size(); ++c)
    if (agreement.drawn[c] != agreement.solved[c])
      add(std::string("nodes drawn as ") + class_name(static_cast<ContactClass>(c)) + ": " +
          std::to_string(agreement.drawn[c]) + ", solved: " + std::to_string(agreement.solved[c]));
  if (!agreement.wrong.empty())
    add(std::to_string(agreement.wrong.size()) +
        " nodes are drawn in another class than solved: " + list_nodes(agreement.wrong));
  if (agreement.unseen > kMostHiddenNodes * agreement.nodes)
    add(std::to_string(agreement.unseen) + " of " + std::to_string(agreement.nodes) + " nodes are not drawn");
  return findings;
}

}  // namespace hydroscope
