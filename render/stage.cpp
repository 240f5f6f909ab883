// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/stage.h"

#include <vtkActor.h>           // VTK::RenderingCore
#include <vtkCamera.h>          // VTK::RenderingCore
#include <vtkLight.h>           // VTK::RenderingCore
#include <vtkLookupTable.h>     // VTK::CommonCore
#include <vtkNew.h>             // VTK::CommonCore
#include <vtkPlane.h>           // VTK::CommonDataModel
#include <vtkPolyData.h>        // VTK::CommonDataModel
#include <vtkPolyDataMapper.h>  // VTK::RenderingCore
#include <vtkProperty.h>        // VTK::RenderingCore
#include <vtkRenderWindow.h>    // VTK::RenderingCore
#include <vtkRenderer.h>        // VTK::RenderingCore

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

/// One actor and what it shows now.
struct Layer {
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  std::shared_ptr<const void> shape;
  const ColourTable* table = nullptr;
  Range range;
  bool is_cut = false;
};

/// The actors of one view.
struct Scene {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkPlane> cut;
  std::vector<std::unique_ptr<Layer>> surfaces, lines;
};

/// Light that stays with the camera: `place` is where it comes from, x to the
/// right, y up, z towards the viewer.
void add_light(vtkRenderer& renderer, const Vec3& place, double intensity, const Vec3& colour) {
  const vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(place.x(), place.y(), place.z());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetColor(colour.x(), colour.y(), colour.z());
  light->SetIntensity(intensity);
  renderer.AddLight(light);
}

void set_up_light(vtkRenderer& renderer) {
  renderer.AutomaticLightCreationOff();
  renderer.RemoveAllLights();
  add_light(renderer, {-0.4, 0.6, 1.0}, 0.74, {1.0, 0.99, 0.97});   // key, from the upper left
  add_light(renderer, {0.9, 0.1, 0.6}, 0.38, {0.96, 0.98, 1.0});    // fill, from the right
  add_light(renderer, {0.2, -0.8, 0.45}, 0.14, {0.95, 0.97, 1.0});  // from below, keeps undersides readable
}

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
  void show_surface(Layer& layer, const SurfaceItem& item, Scene& scene);
  void show_line(Layer& layer, const LineItem& item, Scene& scene, const Vec3& lift);
  void set_cut(Layer& layer, bool is_cut, Scene& scene);
  void set_ground(Scene& scene, const Theme& theme);
  static void set_camera(Scene& scene, const CameraPose& pose);

  Options options;
  OffscreenContext context;
  std::map<int, Scene> scenes;
};

Scene& Stage::Impl::scene(int slot) {
  const auto [place, is_new] = scenes.try_emplace(slot);
  if (is_new) {
    set_up_light(*place->second.renderer);
    context.window().AddRenderer(place->second.renderer);
  }
  // Taking a renderer out of the window would throw away what it has uploaded.
  for (auto& [other, scene] : scenes) scene.renderer->SetDraw(other == slot);
  return place->second;
}

Layer& Stage::Impl::layer(Scene& scene, std::vector<std::unique_ptr<Layer>>& layers, std::size_t index) {
  while (layers.size() <= index) {
    layers.push_back(std::make_unique<Layer>());
    Layer& added = *layers.back();
    added.actor->SetMapper(added.mapper);
    scene.renderer->AddActor(added.actor);
  }
  return *layers[index];
}

void Stage::Impl::set_cut(Layer& layer, bool is_cut, Scene& scene) {
  if (layer.is_cut == is_cut) return;
  layer.is_cut = is_cut;
  layer.mapper->RemoveAllClippingPlanes();
  if (is_cut) layer.mapper->AddClippingPlane(scene.cut);
}

void Stage::Impl::show_surface(Layer& layer, const SurfaceItem& item, Scene& scene) {
  vtkProperty& property = *layer.actor->GetProperty();
  if (layer.shape != item.surface) {
    layer.shape = item.surface;
    layer.mapper->SetInputData(make_poly_data(*item.surface));
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
  property.SetInterpolationToPhong();
  property.SetAmbient(0.26);
  property.SetDiffuse(0.8);
  property.SetSpecular(0.16);
  property.SetSpecularPower(28.0);
  set_cut(layer, item.is_cut, scene);
  layer.actor->SetVisibility(!item.surface->polygons.empty());
}

void Stage::Impl::show_line(Layer& layer, const LineItem& item, Scene& scene, const Vec3& lift) {
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
  set_cut(layer, item.is_cut, scene);
  layer.actor->SetVisibility(!item.lines->lines.empty());
}

void Stage::Impl::show(Scene& scene, const DrawList& list, const Vec3& lift) {
  if (list.cut) {
    const Vec3 inward = -list.cut->normal;
    scene.cut->SetOrigin(list.cut->point.data());
    scene.cut->SetNormal(inward.data());
  }
  for (std::size_t i = 0; i < list.surfaces.size(); ++i)
    show_surface(layer(scene, scene.surfaces, i), list.surfaces[i], scene);
  for (std::size_t i = list.surfaces.size(); i < scene.surfaces.size(); ++i)
    scene.surfaces[i]->actor->VisibilityOff();
  for (std::size_t i = 0; i < list.lines.size(); ++i)
    show_line(layer(scene, scene.lines, i), list.lines[i], scene, lift);
  for (std::size_t i = list.lines.size(); i < scene.lines.size(); ++i) scene.lines[i]->actor->VisibilityOff();
}

void Stage::Impl::set_ground(Scene& scene, const Theme& theme) {
  const auto& low = theme.background_bottom;
  const auto& high = theme.background_top;
  scene.renderer->SetBackground(low[0] / 255.0, low[1] / 255.0, low[2] / 255.0);
  scene.renderer->SetBackground2(high[0] / 255.0, high[1] / 255.0, high[2] / 255.0);
  scene.renderer->SetGradientBackground(!options.is_flat);
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
Stage::~Stage() = default;
const RendererInfo& Stage::info() const { return impl_->context.info(); }

Image Stage::draw(const DrawList& list, const CameraPose& camera, const Theme& theme, int slot) {
  Scene& scene = impl_->scene(slot);
  const Vec3 towards_viewer = (camera.position - camera.focal).normalized();
  impl_->set_ground(scene, theme);
  impl_->show(scene, list, 2.5e-3 * camera.scale * towards_viewer);
  impl_->set_camera(scene, camera);
  return impl_->context.draw(impl_->options.smoothing);
}

}  // namespace hydroscope
