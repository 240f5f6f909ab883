// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "solver/loading/path.h"

namespace hydroscope {

/// A scene as read from its file: plain values, still in the user's terms.
/// `scene_table.cpp` gives each key its type, unit, default, range and
/// documentation; these aggregates hold the defaults.
/// Exactly one of `tube`, `strip` and `mesh` describes the sheet.

struct TubeScene {            // [tube]: straight round tube along z, axis through the origin
  double radius = 0.0;        // radius_mm: mid-surface; always set after reading
  double outer_radius = 0.0;  // outer_radius_mm: instead of radius_mm; radius = outer_radius - thickness / 2
  double thickness = 0.0;     // thickness_mm
  double length = 0.0;        // length_mm: whole length of the tube (of a slice: width of the strip)
  std::string section = "full";  // section: full | half | quarter | octant | sector | (angles from +x)
  double sector_angle = 5.0;     // sector_angle_deg: only with section = "sector"
  std::string extent = "full";   // extent: full | half (symmetry plane z = 0, end at z = +L/2) | slice
  int elements_around = 0;       // elements_around: over the modelled section
  int elements_along = 1;        // elements_along: over the modelled length (slice: always 1)
  std::vector<std::array<double, 2>> grading_around;  // grading_around = [[angle_deg, relative_size], ...]
  std::vector<std::array<double, 2>> grading_along;   // grading_along = [[z_mm, relative_size], ...]
};

struct StripScene {        // [strip]: sheet strip in the x-y plane, extruded by `width` along z, plane strain
  double thickness = 0.0;  // thickness_mm
  double width = 0.0;      // width_mm (one element)
  std::array<double, 2> start{0, 0};  // start_mm = [x, y]
  double direction = 0.0;             // direction_deg of the first straight, from +x
  double lead_in = 0.0;               // lead_in_mm: straight before the arc
  double arc_radius = 0.0;            // arc_radius_mm: mid-surface, turns left
  double arc_angle = 0.0;             // arc_angle_deg
  double lead_out = 0.0;              // lead_out_mm
  int elements_lead_in = 0, elements_arc = 0, elements_lead_out = 0;
};

struct MeshScene {          // [mesh]: quadrilaterals from a VTU file
  std::string file;         // file
  double unit_scale = 1.0;  // unit_scale: file unit in mm
  double thickness = 0.0;   // thickness_mm
};

struct MaterialScene {  // [material]
  std::string name;
  double youngs_modulus = 0.0;  // youngs_modulus_MPa
  double poisson = 0.3;
  std::string hardening = "elastic";                      // elastic | perfect | swift | voce | table
  double yield_stress = 0.0;                              // yield_stress_MPa: perfect, voce
  double swift_k = 0.0, swift_eps0 = 0.0, swift_n = 0.0;  // swift_K_MPa, swift_eps0, swift_n
  double voce_q = 0.0, voce_b = 0.0;                      // voce_Q_MPa, voce_b: sy + Q (1 - exp(-b ep))
  std::vector<std::array<double, 2>> table;               // table = [[plastic strain, MPa], ...]
  std::string yield = "j2";                               // j2 | hill48 (axis 1 along the tube axis / strip)
  double r0 = 1.0, r45 = 1.0, r90 = 1.0;
  double yield_rounding = 0.0005;  // yield_rounding: half width of the onset of yielding, of the flow stress
};

struct ShellScene {  // [shell]
  int thickness_points = 5;
  std::string thickness_rule = "gauss";  // gauss | lobatto | simpson | split_gauss (points / 2 in each half)
  std::string through_wall_stress = "off";  // off | mean (sigma33 = mean of the two faces' pressures)
  bool director_stiffness = true;           // director_stiffness: second variation of the fibre (K_rot)
  bool curvature_terms = true;              // curvature_terms: the layers' metric to second order in zeta
};

struct LoadScene {                   // [load]
  std::string control = "pressure";  // pressure | volume
  Path pressure;                     // pressure_MPa = [[s, MPa], ...]
  Path volume_ratio;  // volume_ratio = [[s, V/V0], ...]: enclosed volume against the initial one
  Path axial_feed;    // axial_feed_mm = [[s, mm], ...]: each end moves inwards by this much
  std::string pressure_surface = "mid";  // mid | inner
  bool load_stiffness = true;            // load_stiffness: false only to show the direction-fixed load
};

struct EndsScene {                // [ends]: tube ends (z = +-L/2; of a half extent only z = +L/2)
  std::string axial = "held";     // held | free | feed
  std::string radial = "free";    // held | free
  std::string rotation = "free";  // held | free
};

/// Edge of a strip: which = [edge.start] or [edge.end].
struct EdgeScene {
  std::vector<std::string> hold;  // hold = ["x", "y", "rotation"]
  Path move_x, move_y;            // move_x_mm, move_y_mm: prescribed displacement paths
  Path force_x, force_y;          // force_x_N_per_mm, ..: dead line force per mm of width
  Path tension;                   // tension_N_per_mm: pulls along the edge's current outward tangent
  Path moment;                    // moment_N: turns the edge about z, N mm per mm of width
};

struct ToolScene {                 // [tool.NAME]
  std::string shape = "mesh";      // mesh | points | plane | cylinder | box | torus
  std::string file;                // mesh: STL, OBJ, PLY; points: grid file; relative to the scene file
  double unit_scale = 1.0;         // mesh: file unit in mm (1 = file is in mm)
  std::string normals = "area";    // mesh, points: facet | plain | area | angle | max
  std::string surface = "smooth";  // surface: mesh: smooth (facets bent to fit their normals) | facets |
                                   // quads | nagata | points
  double pitch = 0.0;              // pitch_mm: surface = points
  std::array<double, 3> height_axis{0, 0, 1};  // height_axis: surface = points, in the file's axes
  std::string search = "tree";                 // search: mesh: tree | grid | all
  std::string projection = "prism";            // projection: surface = facets: prism | orthogonal
  double crease_angle = 40.0;                  // crease_angle_deg: sharper edges are reported
  bool flip = false;                           // flip: turn all facets around
  std::array<double, 3> position{0, 0, 0};     // position_mm: moves the tool after rotation
  std::array<double, 3> rotation{0, 0, 0};     // rotation_deg: about x, then y, then z
  std::array<double, 3> point{0, 0, 0};        // plane: a point [mm]; cylinder, torus: centre
  std::array<double, 3> direction{0, 0, 1};    // plane: normal into free space; cylinder, torus: axis
  double radius = 0.0;          // radius_mm: cylinder; torus: distance of tube centre from its axis
  double minor_radius = 0.0;    // minor_radius_mm: torus
  std::string side = "inside";  // cylinder, box, torus: sheet is inside | outside
  double half_width = 0.0, half_height = 0.0;  // half_width_mm (x), half_height_mm (y): box along z
  double corner_radius = 0.0;                  // corner_radius_mm: box
  double friction = 0.0;                       // friction: Coulomb
  std::string face = "outer";                  // face of the sheet that meets it: outer | inner
  std::vector<std::array<double, 4>> motion;   // motion_mm = [[s, dx, dy, dz], ...]
  std::optional<double> leaves_at;             // leaves_at_s: the tool is taken away at this time
  double known_radius = 0.0;                   // known_radius_mm: with contact.curvature = known-radius
};

struct ContactScene {      // [contact]
  double tolerance = 0.0;  // tolerance_mm: a point closer than this touches; 0 = thickness / 1000
  double wall_stiffness =
      1.0;  // wall_stiffness: of the outer half of the wall, in 2 E / h per area; 0 = rigid
  double stick_stiffness = 0.1;            // stick_stiffness: E_t = this * E / h per area (4.45)
  double release_tolerance = 0.01;         // release_tolerance: tension against the fluid's share of the node
  std::string curvature = "symmetric";     // curvature: none | known-radius | symmetric | full (K_C)
  std::string constraint = "elimination";  // constraint: elimination | penalty
  double penalty = 1e40;                   // penalty_N_per_mm: alpha of (4.58)
  std::string friction_law = "return-mapping";  // friction_law: return-mapping | one-step-behind | stick
  std::string release = "full";                 // release: full | fluid | sign
};

struct IncrementScene {          // [increment]
  double initial = 0.0;          // initial_s: 0 = 1/100 of the whole time
  double smallest = 1e-6;        // smallest: floor, fraction of the whole time
  double largest = 0.02;         // largest: fraction of the whole time
  double max_strain = 0.03;      // max_strain: largest strain increment
  double max_rotation = 3.0;     // max_rotation_deg
  double max_slide = 1.0;        // max_slide: sliding in tool facets or sheet elements
  double max_penetration = 0.2;  // max_penetration: by which free nodes may overshoot a tool before the
                                 // corrector, of the thickness
  std::vector<std::string>
      stop_at;              // stop_at: yield | release | slip: events that limit the increment (r1, r5, r6)
  double cluster = 0.1;     // cluster: share by which such an event may be overrun, to take others along
  double tolerance = 1e-3;  // tolerance: out-of-balance force against the reference force
  int max_iterations = 20;  // max_iterations
  std::string correction = "newton";  // correction: newton | none | one-step-behind | algoneq
  double r_safe = 2.0;                // r_safe: R_safe of one-step-behind (4.25)
  int algoneq_passes = 1;             // algoneq_passes: solves with the out-of-balance force alone (4.27)
  std::string control = "r_min";      // control: r_min | error
  double error_tolerance = 1e-3;      // error_tolerance: of the embedded pair, against the displacement
};

struct LimitsScene {                 // [limits]
  std::string on_necking = "mark";   // mark | stop
  double min_thickness_ratio = 0.3;  // min_thickness_ratio: ends the run (bursting)
  double max_plastic_strain = 2.0;   // max_plastic_strain: ends the run (bursting)
  double localisation = 8.0;         // localisation: strain rate of a zone against its neighbours
};

/// One number a history row. Which keys count depends on `kind`.
struct QuantityScene {  // [quantity.NAME]
  std::string kind;  // thickness | radius | corner_radius | contact_pressure | contact_force | bend_radius |
                     // bending_moment | edge_force | volume | sum | ratio
  double angle = 0.0;                          // angle_deg: where around the tube (nearest interpolation)
  double z = 0.0;                              // z_mm
  double position = 0.0;                       // position: 0..1 along a strip
  std::array<double, 2> position_range{0, 1};  // position_range: bend_radius, bending_moment
  std::string face = "mid";                    // mid | outer | inner (radius)
  double half_width = 0.0;  // half_width_mm: corner_radius = (sqrt2 a - d)/(sqrt2 - 1), outer face
  std::string tool;         // tool: contact_force
  std::array<double, 2> range{0, 360};  // angle_range_deg: contact_force; per mm of modelled length
  std::string edge = "end";             // edge: start | end (edge_force)
  std::vector<std::string> of;          // of: names (sum, ratio)
  std::vector<double> factors;          // factors: one a name (sum)
};

struct StopScene {  // [stop]: end the run (completed) when a quantity passes a value
  std::string quantity;
  std::optional<double> below, above;
};

struct FramesScene {  // [frames]
  std::vector<std::string> views{"contact-map", "tool-normals", "slip"};
  std::string pick = "number";                          // pick: number | interval | every
  int number = 60;                                      // number: frames over the whole process time
  double interval = 0.0;                                // interval_s
  std::array<int, 2> size{1280, 720};                   // size_px
  std::string camera = "fixed";                         // fixed | orbit | look-at
  double azimuth = 35.0, elevation = 25.0, zoom = 1.0;  // azimuth_deg, elevation_deg
  double orbit = 360.0;                                 // orbit_deg: turn over the sequence
  int look_at_node = -1;                                // look_at_node
  std::string theme = "light";                          // light | dark
  bool mirror = true;                                   // mirror: show the whole part
  bool facet_normals = false;                           // facet_normals: in tool-normals
  double tool_opacity = 0.35;
  std::string animation = "webp";  // none | webp | mp4
  double frames_per_second = 20.0;
};

/// A setting that the program has chosen where `accuracy` is asked for, and why.
struct Choice {
  std::string key, value, reason;
};

struct StatesScene {  // [states]
  int number = 20;    // number: states kept over the whole process time (and always first and last)
};

struct Scene {
  std::string file;       // path of the scene file
  std::string directory;  // its folder: tool files are relative to it
  std::string title;
  double accuracy = 0.0;  // accuracy: relative error that the quantities may have; 0 = settings are the user's
  std::string sheet;  // "tube" | "strip" | "mesh": which table was given
  TubeScene tube;
  StripScene strip;
  MeshScene mesh;
  MaterialScene material;
  ShellScene shell;
  LoadScene load;
  EndsScene ends;
  std::map<std::string, EdgeScene> edges;
  std::map<std::string, ToolScene> tools;
  ContactScene contact;
  IncrementScene increment;
  LimitsScene limits;
  std::map<std::string, QuantityScene> quantities;
  StopScene stop;
  FramesScene frames;
  StatesScene states;

  /// Full keys whose values `accuracy` takes as the user's word.
  std::set<std::string> given;
  std::vector<Choice> choices;  // what was chosen; empty before, and without `accuracy`

  /// Process time of the last point of any path [s].
  double end_time() const;
};

}  // namespace hydroscope
