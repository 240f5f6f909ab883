// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/inspect/contact_log.h"
#include "app/inspect/facet_noise.h"
#include "app/inspect/sheet_history.h"
#include "app/inspect/tool_motion.h"

namespace hydroscope {

constexpr double kUnknown =
    std::numeric_limits<double>::quiet_NaN();  // printed as "-", null or an empty cell

/// What is measured around one letting go. Not known is NaN.
struct ReleaseFigures {
  double pressure_before = kUnknown;          ///< fluid, increment before [MPa]
  double pressure = kUnknown;                 ///< fluid, this increment [MPa]
  double area = kUnknown;                     ///< the node's share of the mid-surface [mm^2]
  double fluid_share = kUnknown;              ///< p A of the increment before [N]
  double force_share = kUnknown;              ///< normal force before / fluid share
  double patch_force_share = kUnknown;        ///< the same of the whole patch, sum over sum
  ReleaseNote release;                        ///< of the moment itself
  double contact_pressure_before = kUnknown;  ///< smoothed, last state before [MPa]
  double contact_pressure_after = kUnknown;   ///< smoothed, first state from then on while free [MPa]
  int state_before = -1, state_after = -1;    ///< increments of these two states; -1 none
  double gap_reached = kUnknown;    ///< largest while free: event and states [mm]; infinite: left the band
  double opening_speed = kUnknown;  ///< gap of the event over the increment's time [mm/s]
  double gap_growth = kUnknown;     ///< from the event to the first state after it, still free [mm/s]
  double facet_angle = kUnknown;    ///< between the tool's facets at the node [deg]
  double facet_sagitta = kUnknown;  ///< of the tool's facets off the true surface [mm]
  double facet_noise = kUnknown;    ///< scatter of contact pressure by the tool's facets [MPa]
  double facet_noise_share = kUnknown;  ///< of the fluid's pressure: the same times A over the fluid share
  double patch_noise_share = kUnknown;  ///< root of the squares' sum over the patch, over its fluid share
  int toggles = 0;                      ///< lettings go and comings back in the fullest window that holds it
  int taken_back = 0;  ///< releases taken back at once, within the window's increments before and after
  double tool_retreat =
      kUnknown;             ///< way of its tool off the sheet in this increment [mm]; negative: it came on
  std::string moving_tool;  ///< another tool that moved most in this increment; empty: none
  double moving_way = 0.0;  ///< by how much [mm]
};

/// Whether a letting go is one of the real wall.
enum class Verdict { kPhysical, kNoise, kChatter };
const char* to_string(Verdict verdict);

/// One touch of one node with one tool, from touching to letting go. Indices are those of the log's events.
struct Episode {
  int node = -1;
  int tool = -1;
  std::optional<std::size_t> touched;   ///< touch or retouch; none: in contact from the start
  std::vector<std::size_t> changes;     ///< stick and slip
  std::vector<std::size_t> taken_back;  ///< let go and pushed back within one increment
  std::optional<std::size_t> let_go;    ///< none: still in contact at the end
  std::optional<std::size_t> back;      ///< the next touch of the same node and tool
  ReleaseFigures figures;               ///< of `let_go`
  Verdict verdict = Verdict::kPhysical;
  std::string reason;  ///< the verdict in words, with its figures
  int patch = -1;      ///< index into the patches; -1: has not let go
};

/// Orders the events into episodes, by the event that began each. Throws
/// InputError with file and line when a node touches twice, or lets go twice, without the other between.
std::vector<Episode> make_episodes(const ContactLog& log);

/// Window of increments within which lettings go and comings back are counted.
constexpr int kToggleWindow = 5;

/// Most lettings go and comings back within kToggleWindow increments, over all
/// windows that hold `at`. `toggles`: increments of all of them, sorted.
int count_toggles(const std::vector<int>& toggles, int at);

/// Fills `figures` of all episodes that ended. `motions`: one a tool, or none.
void measure_releases(const ContactLog& log, const SheetHistory& sheet, const FacetNoiseModel& noise,
                      const std::vector<ToolMotion>& motions, std::vector<Episode>& episodes);

/// What changed as it let go, the first of: "tool withdrawn", "unloading", "tool comes on", "tool moves"
/// (another one), "loading", "steady".
std::string find_drive(const ReleaseFigures& figures);

}  // namespace hydroscope
