// SPDX-License-Identifier: GPL-3.0-or-later
// The one table of scene keys. Defaults are those of the aggregates in scene.h.
#include "solver/scene/scene_table.h"

#include <algorithm>

namespace hydroscope {
namespace {

Scene& part_of(Scene& scene, const std::string&, const Scene*) { return scene; }
TubeScene& part_of(Scene& scene, const std::string&, const TubeScene*) { return scene.tube; }
StripScene& part_of(Scene& scene, const std::string&, const StripScene*) { return scene.strip; }
MeshScene& part_of(Scene& scene, const std::string&, const MeshScene*) { return scene.mesh; }
MaterialScene& part_of(Scene& scene, const std::string&, const MaterialScene*) { return scene.material; }
ShellScene& part_of(Scene& scene, const std::string&, const ShellScene*) { return scene.shell; }
LoadScene& part_of(Scene& scene, const std::string&, const LoadScene*) { return scene.load; }
EndsScene& part_of(Scene& scene, const std::string&, const EndsScene*) { return scene.ends; }
ContactScene& part_of(Scene& scene, const std::string&, const ContactScene*) { return scene.contact; }
IncrementScene& part_of(Scene& scene, const std::string&, const IncrementScene*) { return scene.increment; }
LimitsScene& part_of(Scene& scene, const std::string&, const LimitsScene*) { return scene.limits; }
StopScene& part_of(Scene& scene, const std::string&, const StopScene*) { return scene.stop; }
FramesScene& part_of(Scene& scene, const std::string&, const FramesScene*) { return scene.frames; }
StatesScene& part_of(Scene& scene, const std::string&, const StatesScene*) { return scene.states; }
EdgeScene& part_of(Scene& scene, const std::string& name, const EdgeScene*) { return scene.edges[name]; }
ToolScene& part_of(Scene& scene, const std::string& name, const ToolScene*) { return scene.tools[name]; }
QuantityScene& part_of(Scene& scene, const std::string& name, const QuantityScene*) {
  return scene.quantities[name];
}

template <class Part, class Value>
const Part* owner_of(Value Part::*);

template <auto Member>
SceneSlot slot_of(Scene& scene, const std::string& name) {
  using Part = std::remove_pointer_t<decltype(owner_of(Member))>;
  return &(part_of(scene, name, static_cast<Part*>(nullptr)).*Member);
}

template <auto Member>
SceneKey key(std::string name, std::string unit, std::string doc) {
  SceneKey made;
  made.name = std::move(name);
  made.unit = std::move(unit);
  made.doc = std::move(doc);
  made.slot = &slot_of<Member>;
  return made;
}

constexpr double kMany = 1e9;

SceneTable make_top() {
  return {
      "",
      "Before the first table.",
      {},
      {
          key<&Scene::title>("title", "", "What the scene is, in a line; shown in frames and reports."),
          key<&Scene::accuracy>(
              "accuracy", "",
              "Relative error that the quantities may have: chooses mesh, increments, thickness points and "
              "the smallest symmetric part, and estimates the error at the end (docs/accuracy.md). "
              "Without it the settings are as given; 0 is without it.")
              .in(0, 0.2),
      }};
}

SceneTable make_tube() {
  using T = TubeScene;
  return {
      "tube",
      "A straight round tube along z, its axis through the origin. Exactly one of `[tube]`, `[strip]` and "
      "`[mesh]` describes the sheet.",
      {},
      {
          key<&T::radius>("radius_mm", "mm", "Radius of the mid-surface; give this or `outer_radius_mm`.")
              .in(0.5, 1e4),
          key<&T::outer_radius>("outer_radius_mm", "mm", "Radius of the outer face, instead of `radius_mm`.")
              .in(0.5, 1e4),
          key<&T::thickness>("thickness_mm", "mm", "Wall thickness at the start.").in(0.005, 100).required(),
          key<&T::length>("length_mm", "mm",
                          "Length of the whole tube; of a slice, the width of its one row of elements.")
              .in(0.005, 1e5)
              .required(),
          key<&T::section>(
              "section", "",
              "Part of the section that is modelled, from the +x direction on; the rest is its mirror image.")
              .one_of({"full", "half", "quarter", "octant", "sector"}),
          key<&T::sector_angle>("sector_angle_deg", "deg",
                                "Opening of the modelled wedge (axisymmetric behaviour).")
              .in(0.01, 90)
              .when("section", {"sector"}),
          key<&T::extent>(
              "extent", "",
              "Part of the length that is modelled: all of it, the half z >= 0, or a slice in plane strain.")
              .one_of({"full", "half", "slice"}),
          key<&T::elements_around>("elements_around", "",
                                   "Elements over the modelled section; needed, unless `accuracy` is given.")
              .in(1, 100000),
          key<&T::elements_along>("elements_along", "", "Elements over the modelled length; a slice has one.")
              .in(1, 100000),
          key<&T::grading_around>(
              "grading_around", "",
              "Element sizes around: rows of angle in degrees and relative size, linear in between.")
              .in(1e-3, 1e3),
          key<&T::grading_along>("grading_along", "",
                                 "Element sizes along: rows of z in mm and relative size, linear in between.")
              .in(1e-3, 1e3),
      }};
}

SceneTable make_strip() {
  using T = StripScene;
  return {
      "strip",
      "A strip of sheet in the x-y plane, one element wide along z, in plane strain: straight, arc, "
      "straight.",
      {},
      {
          key<&T::thickness>("thickness_mm", "mm", "Sheet thickness at the start.").in(0.005, 100).required(),
          key<&T::width>("width_mm", "mm", "Width along z, one element.").in(0.005, 1e5).required(),
          key<&T::start>("start_mm", "mm", "First point of the mid-surface, x and y.").in(-1e5, 1e5),
          key<&T::direction>("direction_deg", "deg", "Direction in which the first straight runs, from +x.")
              .in(-360, 360),
          key<&T::lead_in>("lead_in_mm", "mm", "Length of the straight before the arc.").in(0, 1e5),
          key<&T::arc_radius>("arc_radius_mm", "mm",
                              "Radius of the mid-surface in the arc, which turns left.")
              .in(0, 1e5),
          key<&T::arc_angle>("arc_angle_deg", "deg", "Angle of the arc.").in(0, 360),
          key<&T::lead_out>("lead_out_mm", "mm", "Length of the straight after the arc.").in(0, 1e5),
          key<&T::elements_lead_in>("elements_lead_in", "", "Elements on the first straight.").in(0, 100000),
          key<&T::elements_arc>("elements_arc", "", "Elements on the arc.").in(0, 100000),
          key<&T::elements_lead_out>("elements_lead_out", "", "Elements on the last straight.").in(0, 100000),
      }};
}

SceneTable make_mesh() {
  using T = MeshScene;
  return {
      "mesh",
      "A sheet of quadrilaterals read from a file, for tubes that are not straight.",
      {},
      {
          key<&T::file>("file", "", "VTU file, relative to the scene file.").required(),
          key<&T::unit_scale>("unit_scale", "",
                              "Length of the file's unit in mm (1000 for a file in metres).")
              .in(1e-6, 1e6),
          key<&T::thickness>("thickness_mm", "mm", "Wall thickness at the start.").in(0.005, 100).required(),
      }};
}

SceneTable make_material() {
  using T = MaterialScene;
  return {
      "material",
      "Elastic-plastic sheet: isotropic hardening, J2 or Hill 1948.",
      {},
      {
          key<&T::name>("name", "", "Name for reports."),
          key<&T::youngs_modulus>("youngs_modulus_MPa", "MPa", "Young's modulus.").in(1, 1e7).required(),
          key<&T::poisson>("poisson", "", "Poisson's ratio.").in(0, 0.499),
          key<&T::hardening>("hardening", "", "Law of the flow stress over the equivalent plastic strain.")
              .one_of({"elastic", "perfect", "swift", "voce", "table"}),
          key<&T::yield_stress>("yield_stress_MPa", "MPa", "Flow stress at first yield.")
              .in(1e-3, 1e6)
              .when("hardening", {"perfect", "voce"})
              .required(),
          key<&T::swift_k>("swift_K_MPa", "MPa", "K in K (eps0 + eps_p)^n.")
              .in(1e-3, 1e6)
              .when("hardening", {"swift"})
              .required(),
          key<&T::swift_eps0>("swift_eps0", "", "eps0 in K (eps0 + eps_p)^n.")
              .in(1e-9, 1)
              .when("hardening", {"swift"})
              .required(),
          key<&T::swift_n>("swift_n", "", "n in K (eps0 + eps_p)^n.")
              .in(0, 1)
              .when("hardening", {"swift"})
              .required(),
          key<&T::voce_q>("voce_Q_MPa", "MPa", "Q in sigma_y + Q (1 - exp(-b eps_p)).")
              .in(0, 1e6)
              .when("hardening", {"voce"})
              .required(),
          key<&T::voce_b>("voce_b", "", "b in sigma_y + Q (1 - exp(-b eps_p)).")
              .in(1e-6, 1e6)
              .when("hardening", {"voce"})
              .required(),
          key<&T::table>("table", "", "Rows of plastic strain and flow stress in MPa, the first at strain 0.")
              .in(1e-3, 1e6)
              .when("hardening", {"table"})
              .required(),
          key<&T::yield>("yield", "",
                         "Yield function; axis 1 of `hill48` runs along the tube's axis or the strip.")
              .one_of({"j2", "hill48"}),
          key<&T::r0>("r0", "", "Lankford coefficient along axis 1.").in(0.05, 20).when("yield", {"hill48"}),
          key<&T::r45>("r45", "", "Lankford coefficient at 45 degrees.")
              .in(0.05, 20)
              .when("yield", {"hill48"}),
          key<&T::r90>("r90", "", "Lankford coefficient across axis 1.")
              .in(0.05, 20)
              .when("yield", {"hill48"}),
          key<&T::yield_rounding>(
              "yield_rounding", "",
              "Half width of the onset of yielding, of the flow stress: an overstress within it turns from "
              "elastic "
              "to plastic gradually. Saves the corrector most of its work where a wall neither loads nor "
              "unloads; 0 is a sharp corner.")
              .in(0, 0.05),
      }};
}

SceneTable make_shell() {
  using T = ShellScene;
  return {"shell",
          "The shell element.",
          {},
          {
              key<&T::thickness_points>("thickness_points", "", "Integration points through the thickness.")
                  .in(1, 31),
              key<&T::thickness_rule>(
                  "thickness_rule", "",
                  "Where they stand; `split_gauss` puts half of them into each half of the wall.")
                  .one_of({"gauss", "lobatto", "simpson", "split_gauss"}),
              key<&T::through_wall_stress>("through_wall_stress", "",
                                           "Stress through the wall in the yield function: none, or the mean "
                                           "of the pressures on the two faces.")
                  .one_of({"off", "mean"}),
              key<&T::director_stiffness>("director_stiffness", "",
                                          "Whether the tangent holds the second variation of the fibre that "
                                          "carries a moment (mechanics of large bending)."),
              key<&T::curvature_terms>("curvature_terms", "",
                                       "Whether a layer's metric is of second order in its distance from "
                                       "the mid-surface; false leaves out what curvature squares."),
          }};
}

SceneTable make_load() {
  using T = LoadScene;
  return {
      "load",
      "Inner fluid and axial feed as piecewise-linear paths of process time.",
      {},
      {
          key<&T::control>("control", "", "What the fluid imposes; `volume` passes a pressure maximum.")
              .one_of({"pressure", "volume"}),
          key<&T::pressure>("pressure_MPa", "MPa", "Inner pressure; used with control = \"pressure\".")
              .in(-1e4, 1e4),
          key<&T::volume_ratio>("volume_ratio", "",
                                "Enclosed volume against the initial one; used with control = \"volume\".")
              .in(0.01, 1e3),
          key<&T::axial_feed>("axial_feed_mm", "mm",
                              "Way by which each end moves inwards; needs axial = \"feed\" in `[ends]`.")
              .in(-1e4, 1e4),
          key<&T::pressure_surface>("pressure_surface", "",
                                    "Surface on which the pressure acts: the mid-surface, or the inner face.")
              .one_of({"mid", "inner"}),
          key<&T::load_stiffness>("load_stiffness", "",
                                  "Whether the tangent knows that the pressure follows the wall; false shows "
                                  "what its absence costs."),
      }};
}

SceneTable make_ends() {
  using T = EndsScene;
  return {"ends",
          "Ends of the tube (z = +L/2 and -L/2; of a half extent only z = +L/2).",
          {},
          {
              key<&T::axial>("axial", "", "Along the axis: held, free, or moved inwards by `axial_feed_mm`.")
                  .one_of({"held", "free", "feed"}),
              key<&T::radial>("radial", "", "Across the axis.").one_of({"held", "free"}),
              key<&T::rotation>("rotation", "", "Rotation of the wall.").one_of({"held", "free"}),
          }};
}

SceneTable make_edge() {
  using T = EdgeScene;
  return {"edge",
          "Ends of the strip: `[edge.start]` and `[edge.end]`.",
          {"start", "end"},
          {
              key<&T::hold>("hold", "", "What does not move.").one_of({"x", "y", "rotation"}),
              key<&T::move_x>("move_x_mm", "mm", "Displacement along x.").in(-1e5, 1e5),
              key<&T::move_y>("move_y_mm", "mm", "Displacement along y.").in(-1e5, 1e5),
              key<&T::force_x>("force_x_N_per_mm", "N_per_mm",
                               "Force along x per mm of width; keeps its direction.")
                  .in(-1e6, 1e6),
              key<&T::force_y>("force_y_N_per_mm", "N_per_mm",
                               "Force along y per mm of width; keeps its direction.")
                  .in(-1e6, 1e6),
              key<&T::tension>("tension_N_per_mm", "N_per_mm",
                               "Pull per mm of width along the edge's current outward direction.")
                  .in(-1e6, 1e6),
              key<&T::moment>("moment_N", "N",
                              "Bending moment per width, in N mm per mm: turns the edge about z, from x "
                              "towards y; needs an edge that may rotate.")
                  .in(-1e6, 1e6),
          }};
}

// NOLINTNEXTLINE(readability-function-size): rows of a table
SceneTable make_tool() {
  using T = ToolScene;
  const std::vector<std::string> round = {"cylinder", "torus"};
  const std::vector<std::string> from_file = {"mesh", "points"};
  return {
      "tool",
      "A rigid tool, by a name of your choice.",
      {"*"},
      {
          key<&T::shape>("shape", "",
                         "A mesh from a file, heights on a grid from a file, or an exact surface.")
              .one_of({"mesh", "points", "plane", "cylinder", "box", "torus"}),
          key<&T::file>(
              "file", "",
              "STL, OBJ or PLY file; of `points` a grid file (docs/tools.md). Relative to the scene file.")
              .when("shape", from_file)
              .required(),
          key<&T::unit_scale>("unit_scale", "",
                              "Length of the file's unit in mm (1000 for a file in metres).")
              .in(1e-6, 1e6)
              .when("shape", from_file),
          key<&T::normals>("normals", "",
                           "How node normals average those of the facets around: not at all, (4.3), (4.4), "
                           "by angle, or as N. Max 1999.")
              .one_of({"facet", "plain", "area", "angle", "max"})
              .when("shape", from_file),
          key<&T::surface>(
              "surface", "",
              "Facets bent to fit their node normals (second order, after Nagata), flat as they are, "
              "bilinear "
              "quadrilaterals (4.2), quadratic Nagata patches, or a point set sampled from the mesh.")
              .one_of({"smooth", "facets", "quads", "nagata", "points"})
              .when("shape", {"mesh"}),
          key<&T::pitch>("pitch_mm", "mm", "Distance of the points that are sampled from the mesh.")
              .in(1e-4, 1e4)
              .when("surface", {"points"})
              .required(),
          key<&T::height_axis>(
              "height_axis", "",
              "Direction in the file's axes along which heights are sampled, from the tool to free space.")
              .in(-1e5, 1e5)
              .when("surface", {"points"}),
          key<&T::search>(
              "search", "",
              "How near facets are found: bounding-volume tree, uniform grid, or trying all. The result is "
              "the same, the cost is not.")
              .one_of({"tree", "grid", "all"})
              .when("shape", {"mesh"}),
          key<&T::projection>(
              "projection", "",
              "How a point is paired with a facet: along the interpolated normal, or along the facet's, "
              "which loses points over convex edges.")
              .one_of({"prism", "orthogonal"})
              .when("surface", {"facets"}),
          key<&T::crease_angle>(
              "crease_angle_deg", "deg",
              "Normals are not averaged over edges sharper than this; such edges are reported.")
              .in(1, 180)
              .when("shape", from_file),
          key<&T::flip>("flip", "",
                        "Turns all facets around, for a file whose facets face away from the sheet.")
              .when("shape", from_file),
          key<&T::position>("position_mm", "mm", "Moves the tool, after its rotation.").in(-1e5, 1e5),
          key<&T::rotation>("rotation_deg", "deg", "Turns the tool about x, then y, then z.").in(-360, 360),
          key<&T::point>("point_mm", "mm", "A point of the plane; centre of the cylinder or torus.")
              .in(-1e5, 1e5)
              .when("shape", {"plane", "cylinder", "torus"}),
          key<&T::direction>("direction", "",
                             "Normal of the plane into free space; axis of the cylinder or torus.")
              .in(-1e5, 1e5)
              .when("shape", {"plane", "cylinder", "torus"}),
          key<&T::radius>("radius_mm", "mm",
                          "Radius of the cylinder; of a torus, from its axis to the centre of its ring.")
              .in(0.01, 1e5)
              .when("shape", round)
              .required(),
          key<&T::minor_radius>("minor_radius_mm", "mm", "Radius of the ring of a torus.")
              .in(0.01, 1e5)
              .when("shape", {"torus"})
              .required(),
          key<&T::side>("side", "", "Where the sheet is.")
              .one_of({"inside", "outside"})
              .when("shape", {"cylinder", "box", "torus"}),
          key<&T::half_width>("half_width_mm", "mm", "Half of the box along x.")
              .in(0.01, 1e5)
              .when("shape", {"box"})
              .required(),
          key<&T::half_height>("half_height_mm", "mm", "Half of the box along y.")
              .in(0.01, 1e5)
              .when("shape", {"box"})
              .required(),
          key<&T::corner_radius>("corner_radius_mm", "mm", "Radius of the corners of the box.")
              .in(0, 1e5)
              .when("shape", {"box"})
              .required(),
          key<&T::friction>("friction", "", "Coulomb's coefficient of friction.").in(0, 10),
          key<&T::face>("face", "", "Face of the sheet that meets the tool.").one_of({"outer", "inner"}),
          key<&T::motion>("motion_mm", "mm", "Motion: rows of time in s and displacement along x, y and z.")
              .in(-1e5, 1e5),
          key<&T::leaves_at>("leaves_at_s", "s", "Time at which the tool is taken away.").in(0, kMany),
          key<&T::known_radius>("known_radius_mm", "mm",
                                "Radius of the tool where it is curved, for `curvature = \"known-radius\"`; "
                                "exact surfaces know theirs.")
              .in(0.01, 1e6)
              .when("shape", from_file),
      }};
}

SceneTable make_contact() {
  using T = ContactScene;
  return {
      "contact",
      "How contact is found, held and released.",
      {},
      {
          key<&T::tolerance>("tolerance_mm", "mm",
                             "A point nearer than this touches; 0 stands for a thousandth of the thickness.")
              .in(0, 10),
          key<&T::wall_stiffness>(
              "wall_stiffness", "",
              "Stiffness of the wall's outer half under contact pressure, against 2 E / h per "
              "area; 0 stands for a rigid one.")
              .in(0, 1e6),
          key<&T::stick_stiffness>("stick_stiffness", "",
                                   "Tangential stiffness of a sticking node against E / h per area, (4.45).")
              .in(1e-6, 1e6),
          key<&T::release_tolerance>("release_tolerance", "",
                                     "Pull at which a node is let go, against the fluid's share of the node.")
              .in(0, 1),
          key<&T::curvature>("curvature", "",
                             "How the tangent knows the turning normal: not at all, by radii that are known "
                             "(4.11)-(4.22), by the symmetric part of K_C, or by all of it, which takes an "
                             "unsymmetric solver (4.28)-(4.44).")
              .one_of({"none", "known-radius", "symmetric", "full"}),
          key<&T::constraint>("constraint", "",
                              "How prescribed displacements enter: wiped rows and columns, or a penalty on "
                              "the diagonal (4.58)-(4.62). Contact counts among them where `wall_stiffness` "
                              "is 0.")
              .one_of({"elimination", "penalty"}),
          key<&T::penalty>("penalty_N_per_mm", "N_per_mm", "The penalty alpha of (4.58).")
              .in(1.0, 1e60)
              .when("constraint", {"penalty"}),
          key<&T::friction_law>("friction_law", "",
                                "Coulomb friction by return mapping within the increment, one step behind "
                                "(4.47)-(4.49), or pseudo-stick alone (4.45), which never slips.")
              .one_of({"return-mapping", "one-step-behind", "stick"}),
          key<&T::release>("release", "",
                           "When a node lets go: by thresholds, patches and verification; by the sign of its "
                           "normal force with the fluid subtracted; or by the sign of its internal force, as "
                           "in sheet stamping.")
              .one_of({"full", "fluid", "sign"}),
      }};
}

SceneTable make_increment() {
  using T = IncrementScene;
  return {
      "increment",
      "Size of the increments, and what is solved again within them.",
      {},
      {
          key<&T::initial>("initial_s", "s", "First increment; 0 stands for a hundredth of the whole time.")
              .in(0, kMany),
          key<&T::smallest>(
              "smallest", "",
              "Floor, a fraction of the whole time; the run ends when it would have to go below.")
              .in(1e-12, 1),
          key<&T::largest>("largest", "", "Ceiling, a fraction of the whole time.").in(1e-9, 1),
          key<&T::max_strain>("max_strain", "", "Largest strain in one increment (r2); 0: no limit.")
              .in(0, 1),
          key<&T::max_rotation>("max_rotation_deg", "deg",
                                "Largest rotation in one increment (r3); 0: no limit.")
              .in(0, 90),
          key<&T::max_slide>(
              "max_slide", "",
              "Largest sliding in one increment, in tool facets or sheet elements, whichever is smaller; "
              "0: no limit.")
              .in(0, 100),
          key<&T::max_penetration>(
              "max_penetration", "",
              "How far free nodes may overshoot a tool before the corrector, against the thickness (r4); a "
              "large number: no limit.")
              .in(0, 1e6),
          key<&T::stop_at>(
              "stop_at", "",
              "Events at which an increment ends: a point begins to yield (r1), a contact lets go (r5), a "
              "sticking one begins to slip (r6). Without them the corrector finds the events.")
              .one_of({"yield", "release", "slip"}),
          key<&T::cluster>(
              "cluster", "",
              "Share by which such an event may be overrun, so that those just behind it come along.")
              .in(0, 1),
          key<&T::tolerance>("tolerance", "",
                             "Out-of-balance force against the reference force at which the corrector stops.")
              .in(1e-12, 1),
          key<&T::max_iterations>("max_iterations", "",
                                  "Corrector passes before the increment is tried again smaller.")
              .in(1, 1000),
          key<&T::correction>(
              "correction", "",
              "What becomes of out-of-balance forces: iterated away (`newton`), left (`none`), "
              "added to the next increment (4.23)-(4.26), or solved for once more (4.27). All but `newton` "
              "draw the limits tight unless they are given: max_strain 0.003, max_rotation_deg 1, "
              "max_penetration 0.01, stop_at all three, material.yield_rounding 0.")
              .one_of({"newton", "none", "one-step-behind", "algoneq"}),
          key<&T::r_safe>("r_safe", "",
                          "R_safe of (4.25): the out-of-balance force is divided by it before it is added.")
              .in(0.1, 1e6)
              .when("correction", {"one-step-behind"}),
          key<&T::algoneq_passes>("algoneq_passes", "", "Solves with the out-of-balance force alone (4.27).")
              .in(1, 20)
              .when("correction", {"algoneq"}),
          key<&T::control>("control", "",
                           "What sets the increment's size: the limits above (r_min), or besides an estimate "
                           "of its error by an embedded pair (Abbo & Sloan 1996).")
              .one_of({"r_min", "error"}),
          key<&T::error_tolerance>("error_tolerance", "",
                                   "Error of an increment's displacements against the largest displacement, "
                                   "or the thickness while that is larger.")
              .in(1e-9, 1)
              .when("control", {"error"}),
      }};
}

SceneTable make_limits() {
  using T = LimitsScene;
  return {
      "limits",
      "What counts as the end of the wall.",
      {},
      {
          key<&T::on_necking>("on_necking", "",
                              "A wall past the maximum of its force marks the run, or stops it.")
              .one_of({"mark", "stop"}),
          key<&T::min_thickness_ratio>("min_thickness_ratio", "",
                                       "Thickness against the initial one at which the run ends as bursting.")
              .in(0.001, 1),
          key<&T::max_plastic_strain>("max_plastic_strain", "",
                                      "Equivalent plastic strain at which the run ends as bursting.")
              .in(1e-3, 100),
          key<&T::localisation>(
              "localisation", "",
              "Strain rate of a zone against its neighbours at which the run ends as bursting.")
              .in(1, 1e6),
      }};
}

SceneTable make_quantity() {
  using T = QuantityScene;
  const std::vector<std::string> placed = {"thickness", "radius", "corner_radius", "contact_pressure"};
  return {"quantity",
          "A number of your own in every row of history.csv (column `q.NAME`).",
          {"*"},
          {
              key<&T::kind>("kind", "", "What is measured; `sum` and `ratio` combine other quantities.")
                  .one_of({"thickness", "radius", "corner_radius", "contact_pressure", "contact_force",
                           "bend_radius", "bending_moment", "edge_force", "volume", "sum", "ratio"})
                  .required(),
              key<&T::angle>("angle_deg", "deg",
                             "Where around the tube, from +x (`corner_radius`: 45 if not given).")
                  .in(-360, 360)
                  .when("kind", placed),
              key<&T::z>("z_mm", "mm", "Where along the tube.").in(-1e5, 1e5).when("kind", placed),
              key<&T::position>("position", "", "Where along the strip, from 0 at its start to 1 at its end.")
                  .in(0, 1)
                  .when("kind", {"thickness", "contact_pressure"}),
              key<&T::position_range>("position_range", "",
                                      "Part of the strip for the fitted circle, or for the mean moment.")
                  .in(0, 1)
                  .when("kind", {"bend_radius", "bending_moment"}),
              key<&T::face>("face", "", "Surface whose distance from the axis counts.")
                  .one_of({"mid", "outer", "inner"})
                  .when("kind", {"radius"}),
              key<&T::half_width>("half_width_mm", "mm",
                                  "Half-width a of the die in (sqrt2 a - d) / (sqrt2 - 1), d the distance of "
                                  "the outer face from the axis.")
                  .in(0.01, 1e5)
                  .when("kind", {"corner_radius"})
                  .required(),
              key<&T::tool>("tool", "", "Tool whose force on the sheet is summed, per mm of modelled length.")
                  .when("kind", {"contact_force"})
                  .required(),
              key<&T::range>("angle_range_deg", "deg", "Part of the section over which it is summed.")
                  .in(-360, 360)
                  .when("kind", {"contact_force"}),
              key<&T::edge>("edge", "", "End of the strip: supports and loads, per mm of width.")
                  .one_of({"start", "end"})
                  .when("kind", {"edge_force"}),
              key<&T::of>("of", "", "Names of the quantities that it combines (`ratio`: first over second).")
                  .when("kind", {"sum", "ratio"})
                  .required(),
              key<&T::factors>("factors", "", "Factor of each summand; all 1 if not given.")
                  .in(-1e9, 1e9)
                  .when("kind", {"sum"}),
          }};
}

SceneTable make_stop() {
  using T = StopScene;
  return {"stop",
          "Ends the run, as completed, when a quantity passes a value.",
          {},
          {
              key<&T::quantity>("quantity", "", "Name of the quantity.").required(),
              key<&T::below>("below", "", "It ends when the quantity falls below this."),
              key<&T::above>("above", "", "It ends when the quantity rises above this."),
          }};
}

SceneTable make_frames() {
  using T = FramesScene;
  return {
      "frames",
      "Pictures of the run; each key also has an option on the command line or goes by `--set`.",
      {},
      {
          key<&T::views>("views", "", "Sequences to draw; an empty list draws none.")
              .one_of({"contact-map", "tool-normals", "slip", "thickness", "plastic-strain",
                       "contact-pressure", "gap", "detachment", "chatter", "release-margin"}),
          key<&T::pick>(
              "pick", "",
              "Which states are drawn: a number over the process time, one an interval, or every increment.")
              .one_of({"number", "interval", "every"}),
          key<&T::number>("number", "", "Frames over the whole process time.")
              .in(1, 100000)
              .when("pick", {"number"}),
          key<&T::interval>("interval_s", "s", "Process time between frames.")
              .in(1e-9, kMany)
              .when("pick", {"interval"})
              .required(),
          key<&T::size>("size_px", "px", "Width and height of a frame.").in(64, 8192),
          key<&T::camera>("camera", "", "Camera that stands still, turns around the part, or follows a node.")
              .one_of({"fixed", "orbit", "look-at"}),
          key<&T::azimuth>("azimuth_deg", "deg", "Direction of the first view, around the part.")
              .in(-360, 360),
          key<&T::elevation>("elevation_deg", "deg", "Height of the view above the horizon.").in(-89, 89),
          key<&T::zoom>("zoom", "", "1 fits the part into the frame.").in(0.01, 1000),
          key<&T::orbit>("orbit_deg", "deg", "Turn of the camera over the sequence.")
              .in(-36000, 36000)
              .when("camera", {"orbit"}),
          key<&T::look_at_node>("look_at_node", "", "Node that stays in the centre.")
              .in(0, kMany)
              .when("camera", {"look-at"})
              .required(),
          key<&T::theme>("theme", "", "Colours of background and type.").one_of({"light", "dark"}),
          key<&T::mirror>("mirror", "", "Whether symmetry is mirrored to show the whole part."),
          key<&T::facet_normals>("facet_normals", "",
                                 "Whether `tool-normals` also shows the normals of the facets."),
          key<&T::tool_opacity>("tool_opacity", "", "Opacity of tools in front of the sheet.").in(0, 1),
          key<&T::animation>("animation", "", "Film beside the frames.").one_of({"none", "webp", "mp4"}),
          key<&T::frames_per_second>("frames_per_second", "", "Speed of the film.").in(0.1, 120),
      }};
}

SceneTable make_states() {
  return {"states",
          "States kept for ParaView and for drawing again.",
          {},
          {
              key<&StatesScene::number>("number", "",
                                        "States over the whole process time, beside the first and the last.")
                  .in(1, 100000),
          }};
}

}  // namespace

SceneKey& SceneKey::in(double low, double high) {
  range = {low, high};
  return *this;
}

SceneKey& SceneKey::one_of(std::vector<std::string> names) {
  choices = std::move(names);
  return *this;
}

SceneKey& SceneKey::when(std::string selector, std::vector<std::string> values) {
  condition = {std::move(selector), std::move(values)};
  return *this;
}

SceneKey& SceneKey::required() {
  is_required = true;
  return *this;
}

std::string SceneTable::header() const {
  if (name.empty()) return "top of the file";
  if (!is_named()) return "[" + name + "]";
  return "[" + name + (of.front() == "*" ? ".NAME]" : "." + of.front() + "]");
}

const SceneKey* SceneTable::find(const std::string& wanted) const {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const SceneKey& k) { return k.name == wanted; });
  return found == keys.end() ? nullptr : &*found;
}

std::vector<std::string> SceneTable::key_names() const {
  std::vector<std::string> names;
  for (const SceneKey& k : keys) names.push_back(k.name);
  return names;
}

const std::vector<SceneTable>& scene_tables() {
  static const std::vector<SceneTable> tables = {
      make_top(),    make_tube(),     make_strip(), make_mesh(),   make_material(), make_shell(),
      make_load(),   make_ends(),     make_edge(),  make_tool(),   make_contact(),  make_increment(),
      make_limits(), make_quantity(), make_stop(),  make_frames(), make_states()};
  return tables;
}

const SceneTable* find_scene_table(const std::string& name) {
  for (const SceneTable& table : scene_tables()) {
    if (table.name == name) return &table;
  }
  return nullptr;
}

}  // namespace hydroscope
