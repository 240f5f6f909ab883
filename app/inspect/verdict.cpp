// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/verdict.h"

#include <algorithm>
#include <cmath>

#include "app/inspect/figure_text.h"

namespace hydroscope {
namespace {

std::string describe_return(const ContactEvent& event, const std::optional<int>& back) {
  if (!back) return "it stayed away";
  const int after = *back - event.increment;
  return "it came back after " + std::to_string(after) + (after == 1 ? " increment" : " increments");
}

std::string describe_opening(const ReleaseFigures& f, const VerdictBounds& bounds, bool is_open) {
  if (std::isinf(f.gap_reached)) return "opened until no tool was near";
  return "opened by " + format_figure(f.gap_reached) + " mm" + (is_open ? ", above " : ", not above ") +
         format_figure(bounds.opening) + " mm";
}

std::string describe_noise(double noise, double factor, const char* unit) {
  if (std::isnan(noise)) return " (facet noise: not known)";
  if (noise == 0.0) return " (facet noise: none)";
  if (factor * noise < 0.01) return std::string(" (facet noise: below 0.01") + unit + ")";
  return " (facet noise: " + format_figure(factor * noise) + unit + ")";
}

/// The moment itself, where the run has kept it.
std::string describe_moment(const ReleaseNote& release) {
  if (std::isnan(release.force) || release.threshold == 0.0) return "";
  return "; it let go at " + format_figure(release.force) + " N, threshold " +
         format_figure(-release.threshold) + " N, patch pressure " + format_figure(release.pressure) + " MPa";
}

/// The node's balance in words: what does not press on the tool is drawn off it by the wall.
std::string describe_pull(const ReleaseFigures& f) {
  if (!(f.fluid_share > 0.0) || !(f.release.force < 0.0) || f.release.threshold == 0.0) return "";
  return "; the fluid pushed it on with " + format_figure(f.fluid_share) + " N, the wall drew it off with " +
         format_figure(f.fluid_share - f.release.force) + " N";
}

/// Against the fluid's share; without fluid in N.
std::string describe_force(const ContactEvent& event, const ReleaseFigures& f) {
  if (!std::isnan(f.force_share))
    return "; force before: " + format_figure(100.0 * f.force_share) + " % of the fluid's share" +
           describe_noise(f.facet_noise_share, 100.0, " %") + describe_moment(f.release) + describe_pull(f);
  if (f.fluid_share == 0.0)
    return "; force before: " + format_figure(event.force_before) + " N" +
           describe_noise(f.facet_noise * f.area, 1.0, " N") + describe_moment(f.release);
  return describe_moment(f.release);
}

/// Pulled by more than the tolerance and, where that is known, than the facets' noise.
bool is_pulled(double share, double noise, double tolerance) {
  return share < -(std::isnan(noise) ? tolerance : std::max(tolerance, noise));
}

/// A wall bridges the edges between flat facets: that says something of the mesh, not of the die. Where fluid
/// or tool go back a wall may open as little in earnest.
bool is_within_facets(const ReleaseFigures& f) {
  const std::string drive = find_drive(f);
  return drive != "unloading" && drive != "tool withdrawn" && f.gap_reached <= f.facet_sagitta &&
         f.facet_sagitta > 0.0;
}

/// What the tools did meanwhile.
std::string describe_motion(const ReleaseFigures& f) {
  std::string text;
  if (f.tool_retreat != 0.0 && !std::isnan(f.tool_retreat))
    text = std::string(f.tool_retreat > 0.0 ? "; its tool went back by " : "; its tool came on by ") +
           format_figure(std::abs(f.tool_retreat)) + " mm";
  if (!f.moving_tool.empty())
    text += "; meanwhile '" + f.moving_tool + "' moved by " + format_figure(f.moving_way) + " mm";
  return text;
}

/// What the fluid did meanwhile: a wall may let go as it is unloaded, or be pulled off by its own stretching.
std::string describe_fluid(const ReleaseFigures& f) {
  if (std::isnan(f.pressure) || std::isnan(f.pressure_before)) return "";
  if (f.pressure == 0.0 && f.pressure_before == 0.0) return "; no fluid";
  if (f.pressure == f.pressure_before) return "; the fluid held " + format_figure(f.pressure) + " MPa";
  return std::string(f.pressure < f.pressure_before ? "; unloading" : "; loading") +
         ": the fluid went from " + format_figure(f.pressure_before) + " to " + format_figure(f.pressure) +
         " MPa";
}

std::string describe_load(const ReleaseFigures& f) { return describe_fluid(f) + describe_motion(f); }

std::string describe_taken_back(const ReleaseFigures& f) {
  if (f.taken_back == 0) return "";
  return "; released and taken back at once " + std::to_string(f.taken_back) +
         (f.taken_back == 1 ? " time" : " times") + " within the increments before";
}

}  // namespace

Judgement judge_release(const ContactEvent& event, const std::optional<int>& back, const ReleaseFigures& f,
                        const VerdictBounds& bounds) {
  const std::string returned = describe_return(event, back);
  const bool is_open = f.gap_reached > bounds.opening;
  const std::string opening = describe_opening(f, bounds, is_open);
  if (f.toggles >= bounds.chatter_toggles)
    return {Verdict::kChatter, std::to_string(f.toggles) + " times let go or back within " +
                                   std::to_string(bounds.window) + " increments; " + opening +
                                   describe_load(f)};
  const bool is_gone = event.cause == "tool taken away";
  if (is_gone || event.cause == "edge" || event.cause == "left the tool")
    return {Verdict::kPhysical, (is_gone ? "its tool was taken away; " : "left over the tool's edge; ") +
                                    returned + describe_load(f)};
  if (event.cause == "sign rule" && back && event.force_before > 0.0)
    return {Verdict::kNoise, "a sign rule let it go while it was pressed; " + opening + "; " + returned +
                                 describe_force(event, f) + describe_load(f)};
  if (is_within_facets(f))
    return {Verdict::kNoise, "opened by " + format_figure(f.gap_reached) +
                                 " mm, within the sagitta of the tool's facets, " +
                                 format_figure(f.facet_sagitta) + " mm; " + returned +
                                 describe_force(event, f) + describe_load(f)};
  if (is_open)
    return {Verdict::kPhysical, opening + "; " + returned + describe_force(event, f) + describe_load(f)};
  const bool is_taken_back = f.taken_back > 0 || (back && *back - event.increment <= bounds.window);
  const std::string rest = opening + "; " + returned + describe_taken_back(f) + describe_force(event, f);
  if (!is_taken_back && is_pulled(f.force_share, f.facet_noise_share, bounds.tension))
    return {Verdict::kPhysical, "it was pulled; " + rest + describe_load(f)};
  if (!is_taken_back && is_pulled(f.patch_force_share, f.patch_noise_share, bounds.tension))
    return {Verdict::kPhysical, "its patch was pulled, " + format_figure(100.0 * f.patch_force_share) +
                                    " % of the fluid's share; " + rest + describe_load(f)};
  return {Verdict::kNoise, rest + describe_load(f)};
}

}  // namespace hydroscope
