// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/stage.h"

#include <vtkActor.h>           // VTK::RenderingCore
#include <vtkCamera.h>          // VTK::RenderingCore
#include <vtkLookupTable.h>     // VTK::CommonCore
#include <vtkNew.h>             // VTK::CommonCore
#include <vtkPlane.h>           // VTK::CommonDataModel
#include <vtkPolyData.h>        // VTK::CommonDataModel
#include <vtkPolyDataMapper.h>  // VTK::RenderingCore
#include <vtkProperty.h>        // VTK::RenderingCore
#include <vtkRenderWindow.h>    // VTK::RenderingCore
#include <vtkRenderer.h>        // VTK::RenderingCore
#include <vtkShaderProperty.h>  // VTK::RenderingCore

#include <algorithm>
#include <map>
#include <vector>

#include "render/poly_data.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

void set_colour(vtkProperty& property, Rgb colour) {
  property.SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
}

vtkSmartPointer<vtkLookupTable> make_lookup(const ColourTable& colours, const Range& range) {
  auto lookup = vtkSmartPointer<vtkLookupTable>::New();
  lookup->SetNumberOfTableValues(kColours);
  for (int i = 0; i < kColours; ++i) {
    const Rgb& c = colours[static_cast<std::size_t>(i)];
    lookup->SetTableValue(i, c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
  }
  lookup->SetTableRange(range.low, range.high);
  lookup->SetNanColor(kNoValueColour[0] / 255.0, kNoValueColour[1] / 255.0, kNoValueColour[2] / 255.0, 1.0);
  return lookup;
}

/// The polygons that show the wanted side towards the viewer. A parallel
/// projection sees all of them from one direction, so the others need not be sent: half of the work.
std::vector<std::array<int, 4>> find_seen(const Surface& surface, SurfaceItem::Faces faces,
                                          const Vec3f& direction) {
  const float sign = faces == SurfaceItem::Faces::kFront ? 1.0F : -1.0F;
  std::vector<std::array<int, 4>> seen;
  seen.reserve(surface.polygons.size());
  for (const auto& polygon : surface.polygons) {
    const auto x = [&](std::size_t k) -> const Vec3f& {
      return surface.points[static_cast<std::size_t>(polygon[k])];
    };
    const Vec3f diagonal = x(2) - x(0);
    const auto faces_viewer = [&](const Vec3f& area) { return sign * area.dot(direction) > 0.0F; };
    // A warped quad may show one of its triangles only.
    const bool is_seen = faces_viewer((x(1) - x(0)).cross(diagonal)) ||
                         (polygon[3] >= 0 && faces_viewer(diagonal.cross(x(3) - x(0))));
    if (is_seen) seen.push_back(polygon);
  }
  return seen;
}

void set_plane(vtkPlane& drawn, const std::optional<Plane>& plane) {
  if (!plane) return;
  const Vec3 inward = -plane->normal;
  drawn.SetOrigin(plane->point.data());
  drawn.SetNormal(inward.data());
}

/// One actor and what it shows now.
struct Layer {
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  std::shared_ptr<const void> shape;
  SurfaceItem::Faces faces = SurfaceItem::Faces::kAll;
  Vec3f direction = Vec3f::Zero();
  const ColourTable* table = nullptr;
  Range range;
  bool is_cut = false, is_clipped = false;
};

/// The actors of one view.
struct Scene {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkPlane> cut, clip;
  std::vector<std::unique_ptr<Layer>> surfaces, lines;
};

// Three lights that stay with the camera (x to the right, y up, z towards the
// viewer): a key from the upper left, a fill from the right, a soft one from above.
// Written out instead of VTK's lights, whose general form took half of the drawing time.
constexpr const char* kLight = R"(
  float key = max(dot(normalVCVSOutput, vec3(-0.32, 0.49, 0.81)), 0.0);
  float fill = max(dot(normalVCVSOutput, vec3(0.83, 0.09, 0.55)), 0.0);
  float shine = max(dot(normalVCVSOutput, vec3(-0.17, 0.26, 0.95)), 0.0);
  shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
  float light = 0.41 + 0.09 * normalVCVSOutput.y + 0.45 * key + 0.28 * fill;
  gl_FragData[0] = vec4(light * diffuseColor + 0.11 * shine, opacity);
)";

}  // namespace

struct Stage::Impl {
  explicit Impl(const Options& given)
      : options(given),
        context({.width = given.width * given.smoothing,
                 .height = given.height * given.smoothing,
                 .rasteriser_threads = given.rasteriser_threads}) {}

  Scene& scene(int slot);
  Layer& layer(Scene& scene, std::vector<std::unique_ptr<Layer>>& layers, std::size_t index);
  void show(Scene& scene, const DrawList& list, const Vec3& towards_viewer);
  void show_surface(Layer& layer, const SurfaceItem& item, const Vec3f& direction);
  void show_line(Layer& layer, const LineItem& item, const Vec3& lift);
  static void set_planes(Layer& layer, bool is_cut, bool is_clipped, Scene& scene);
  static void set_camera(Scene& scene, const CameraPose& pose);

  Options options;
  OffscreenContext context;
  std::map<int, Scene> scenes;
};

Scene& Stage::Impl::scene(int slot) {
  const auto [place, is_new] = scenes.try_emplace(slot);
  if (is_new) {
    place->second.renderer->SetBackground(0.0, 0.0, 0.0);  // with alpha 0: see lay_on_ground
    context.window().AddRenderer(place->second.renderer);
  }
  // Taking a renderer out of the window would throw away what it has uploaded.
  for (auto& [other, scene] : scenes) scene.renderer->SetDraw(other == slot);
  return place->second;
}

Layer& Stage::Impl::layer(Scene& scene, std::vector<std::unique_ptr<Layer>>& layers, std::size_t index) {
  const bool is_lit = &layers == &scene.surfaces && !options.is_flat;
  while (layers.size() <= index) {
    layers.push_back(std::make_unique<Layer>());
    Layer& added = *layers.back();
    if (is_lit)
      added.actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, kLight,
                                                                     false);
    added.actor->SetMapper(added.mapper);
    scene.renderer->AddActor(added.actor);
    // Actors are drawn in the order of their coming: lines after all surfaces, whenever these came.
    if (&layers != &scene.surfaces) continue;
    for (const auto& line : scene.lines) scene.renderer->RemoveActor(line->actor);
    for (const auto& line : scene.lines) scene.renderer->AddActor(line->actor);
  }
  return *layers[index];
}

void Stage::Impl::set_planes(Layer& layer, bool is_cut, bool is_clipped, Scene& scene) {
  if (layer.is_cut == is_cut && layer.is_clipped == is_clipped) return;
  layer.is_cut = is_cut;
  layer.is_clipped = is_clipped;
  layer.mapper->RemoveAllClippingPlanes();
  if (is_cut) layer.mapper->AddClippingPlane(scene.cut);
  if (is_clipped) layer.mapper->AddClippingPlane(scene.clip);
}

void Stage::Impl::show_surface(Layer& layer, const SurfaceItem& item, const Vec3f& direction) {
  vtkProperty& property = *layer.actor->GetProperty();
  const bool is_whole = options.is_turned_often || item.faces == SurfaceItem::Faces::kAll;
  const bool is_other_part = !is_whole && (layer.faces != item.faces || layer.direction != direction);
  if (layer.shape != item.surface || is_other_part) {
    layer.shape = item.surface;
    layer.faces = item.faces;
    layer.direction = direction;
    layer.mapper->SetInputData(make_poly_data(
        *item.surface, is_whole ? item.surface->polygons : find_seen(*item.surface, item.faces, direction)));
  }
  const bool has_values = !item.surface->values.empty() && item.table != nullptr;
  layer.mapper->SetScalarVisibility(has_values || !item.surface->colours.empty());
  layer.mapper->SetInterpolateScalarsBeforeMapping(has_values);
  if (has_values && (layer.table != item.table || !(layer.range == item.range))) {
    layer.table = item.table;
    layer.range = item.range;
    layer.mapper->SetLookupTable(make_lookup(*item.table, item.range));
    layer.mapper->UseLookupTableScalarRangeOn();
  }
  set_colour(property, item.colour);
  // Blended in drawing order: VTK's own sorting of translucent shapes costs
  // more than the rest of the picture, and each pixel has one tool wall.
  property.SetOpacity(item.opacity);
  layer.actor->SetForceOpaque(true);
  property.SetFrontfaceCulling(item.faces == SurfaceItem::Faces::kBack);
  property.SetBackfaceCulling(item.faces == SurfaceItem::Faces::kFront);
  property.SetLighting(!options.is_flat);
  property.SetAmbient(0.0);
  property.SetDiffuse(1.0);
  layer.actor->SetVisibility(!item.surface->polygons.empty());
}

void Stage::Impl::show_line(Layer& layer, const LineItem& item, const Vec3& lift) {
  vtkProperty& property = *layer.actor->GetProperty();
  if (layer.shape != item.lines) {
    layer.shape = item.lines;
    layer.mapper->SetInputData(make_poly_data(*item.lines));
  }
  layer.mapper->ScalarVisibilityOff();
  set_colour(property, item.colour);
  property.SetOpacity(item.opacity);
  layer.actor->SetForceOpaque(true);
  property.LightingOff();
  property.SetLineWidth(
      static_cast<float>(item.width * options.smoothing * std::max(1.0, options.height / 720.0)));
  // Along the line of sight a parallel projection does not show the shift.
  layer.actor->SetPosition(lift.x(), lift.y(), lift.z());
  layer.actor->SetVisibility(!item.lines->lines.empty());
}

void Stage::Impl::show(Scene& scene, const DrawList& list, const Vec3& lift) {
  set_plane(*scene.cut, list.cut);
  set_plane(*scene.clip, list.clip);
  const Vec3f direction = lift.normalized().cast<float>();
  const auto hide_after = [](std::vector<std::unique_ptr<Layer>>& layers, std::size_t count) {
    for (std::size_t i = count; i < layers.size(); ++i) layers[i]->actor->VisibilityOff();
  };
  for (std::size_t i = 0; i < list.surfaces.size(); ++i) {
    const SurfaceItem& item = list.surfaces[i];
    Layer& shown = layer(scene, scene.surfaces, i);
    show_surface(shown, item, direction);
    set_planes(shown, item.is_cut, item.is_clipped && list.clip, scene);
  }
  hide_after(scene.surfaces, list.surfaces.size());
  for (std::size_t i = 0; i < list.lines.size(); ++i) {
    const LineItem& item = list.lines[i];
    Layer& shown = layer(scene, scene.lines, i);
    show_line(shown, item, lift);
    set_planes(shown, item.is_cut, item.is_clipped && list.clip, scene);
  }
  hide_after(scene.lines, list.lines.size());
}

void Stage::Impl::set_camera(Scene& scene, const CameraPose& pose) {
  vtkCamera& camera = *scene.renderer->GetActiveCamera();
  camera.ParallelProjectionOn();
  camera.SetPosition(pose.position.data());
  camera.SetFocalPoint(pose.focal.data());
  camera.SetViewUp(pose.up.data());
  camera.SetParallelScale(pose.scale);
  scene.renderer->ResetCameraClippingRange();
}

Stage::Stage(const Options& options) : impl_(std::make_unique<Impl>(options)) {
  require(options.smoothing >= 1 && options.smoothing <= 4, "smoothing is a factor of 1 to 4");
}
void Stage::resize(int width, int height, int smoothing) {
  require(smoothing >= 1 && smoothing <= 4, "smoothing is a factor of 1 to 4");
  Options& options = impl_->options;
  if (options.width == width && options.height == height && options.smoothing == smoothing) return;
  options.width = width;
  options.height = height;
  options.smoothing = smoothing;
  impl_->context.resize(width * smoothing, height * smoothing);
}
Stage::~Stage() = default;
const RendererInfo& Stage::info() const { return impl_->context.info(); }

Image Stage::draw(const DrawList& list, const CameraPose& camera, const Theme& theme, int slot) {
  Scene& scene = impl_->scene(slot);
  const Vec3 towards_viewer = (camera.position - camera.focal).normalized();
  impl_->show(scene, list, 2.5e-3 * camera.scale * towards_viewer);
  impl_->set_camera(scene, camera);
  Image image = impl_->context.draw(impl_->options.smoothing);
  const Rgb bottom = theme.background_bottom;
  lay_on_ground(image, impl_->options.is_flat ? bottom : theme.background_top, bottom);
  return image;
}

}  // namespace hydroscope
