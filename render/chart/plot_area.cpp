// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/chart/plot_area.h"

#include <vtkAxis.h>           // VTK::ChartsCore
#include <vtkBrush.h>          // VTK::RenderingContext2D
#include <vtkChartXY.h>        // VTK::ChartsCore
#include <vtkContext2D.h>      // VTK::RenderingContext2D
#include <vtkContextActor.h>   // VTK::RenderingContext2D
#include <vtkContextItem.h>    // VTK::RenderingContext2D
#include <vtkContextScene.h>   // VTK::RenderingContext2D
#include <vtkDoubleArray.h>    // VTK::CommonCore
#include <vtkFloatArray.h>     // VTK::CommonCore
#include <vtkNew.h>            // VTK::CommonCore
#include <vtkObjectFactory.h>  // VTK::CommonCore
#include <vtkPen.h>            // VTK::RenderingContext2D
#include <vtkPlot.h>           // VTK::ChartsCore
#include <vtkRenderWindow.h>   // VTK::RenderingCore
#include <vtkRenderer.h>       // VTK::RenderingCore
#include <vtkStringArray.h>    // VTK::CommonCore
#include <vtkTable.h>          // VTK::CommonDataModel
#include <vtkVector.h>         // VTK::CommonDataModel

#include "render/chart/marker_shape.h"
#include "render/offscreen_context.h"

namespace hydroscope {
namespace {

constexpr int kSmoothing = 2;  ///< drawn larger by this factor each way, then averaged

/// The markers of a chart, over its lines, in pixels of the window.
class MarkerItem : public vtkContextItem {
 public:
  static MarkerItem* New();
  vtkTypeMacro(MarkerItem, vtkContextItem);

  std::vector<PlotArea::Marker> markers;
  int height = 0;  ///< [px] of the picture

  bool Paint(vtkContext2D* painter) override {
    for (const PlotArea::Marker& marker : markers) paint(*painter, marker);
    return true;
  }

 private:
  void paint(vtkContext2D& painter, const PlotArea::Marker& marker) const {
    const MarkerShape shape = make_marker_shape(marker.shape);
    std::vector<float> outline;
    for (const auto& corner : shape.corners) {
      outline.push_back(static_cast<float>(kSmoothing * (marker.x + 0.5 * marker.size * corner[0])));
      outline.push_back(static_cast<float>(kSmoothing * (height - marker.y + 0.5 * marker.size * corner[1])));
    }
    if (outline.empty()) return;
    const int count = static_cast<int>(shape.corners.size());
    const Rgb& c = marker.colour;
    if (shape.is_filled) {
      // A rim in the colour of the ground keeps markers apart that lie on each other.
      painter.GetPen()->SetLineType(vtkPen::SOLID_LINE);
      painter.GetPen()->SetColor(marker.rim[0], marker.rim[1], marker.rim[2], 255);
      painter.GetPen()->SetWidth(static_cast<float>(kSmoothing * 1.2));
      painter.GetBrush()->SetColor(c[0], c[1], c[2], 255);
      painter.DrawPolygon(outline.data(), count);
      return;
    }
    painter.GetPen()->SetLineType(vtkPen::SOLID_LINE);
    painter.GetPen()->SetColor(c[0], c[1], c[2], 255);
    painter.GetPen()->SetWidth(static_cast<float>(kSmoothing * shape.stroke * marker.size));
    painter.DrawLines(outline.data(), count);
  }
};
vtkStandardNewMacro(MarkerItem);

int find_line_type(ChartLine style) {
  switch (style) {
    case ChartLine::kNone:
      return vtkPen::NO_PEN;
    case ChartLine::kSolid:
      return vtkPen::SOLID_LINE;
    case ChartLine::kDashed:
      return vtkPen::DASH_LINE;
    case ChartLine::kDotted:
      return vtkPen::DOT_LINE;
  }
  return vtkPen::SOLID_LINE;
}

void set_axis(vtkAxis& axis, const std::vector<double>& ticks, const PlotArea& area) {
  const vtkNew<vtkDoubleArray> positions;
  const vtkNew<vtkStringArray> labels;
  for (const double tick : ticks) {
    positions->InsertNextValue(tick);
    labels->InsertNextValue("");
  }
  axis.SetBehavior(vtkAxis::FIXED);
  axis.SetRange(0.0, 1.0);
  axis.SetCustomTickPositions(positions, labels);
  axis.SetTitle("");
  axis.SetLabelsVisible(false);
  axis.SetTicksVisible(false);
  axis.SetGridVisible(!ticks.empty());
  axis.GetGridPen()->SetColor(area.grid[0], area.grid[1], area.grid[2], 255);
  axis.GetGridPen()->SetWidth(kSmoothing);
  axis.GetPen()->SetColor(area.axis[0], area.axis[1], area.axis[2], 255);
  axis.GetPen()->SetWidth(static_cast<float>(kSmoothing * area.axis_width));
}

void add_line(vtkChartXY& chart, const PlotArea::Line& line) {
  if (line.points.size() < 2 || line.style == ChartLine::kNone) return;
  const vtkNew<vtkFloatArray> x, y;
  x->SetName("x");
  y->SetName("y");
  for (const auto& point : line.points) {
    x->InsertNextValue(static_cast<float>(point[0]));
    y->InsertNextValue(static_cast<float>(point[1]));
  }
  const vtkNew<vtkTable> table;
  table->AddColumn(x);
  table->AddColumn(y);
  vtkPlot* plot = chart.AddPlot(vtkChart::LINE);
  plot->SetInputData(table, 0, 1);
  plot->SetColor(line.colour[0], line.colour[1], line.colour[2], 255);
  plot->SetWidth(static_cast<float>(kSmoothing * line.width));
  plot->GetPen()->SetLineType(find_line_type(line.style));
}

}  // namespace

struct PlotAreaPainter::Impl {
  Impl(std::array<int, 2> size, int threads)
      : height(size[1]),
        context(
            {.width = size[0] * kSmoothing, .height = size[1] * kSmoothing, .rasteriser_threads = threads}) {
    actor->GetScene()->SetRenderer(renderer);
    actor->GetScene()->SetScaleTiles(false);
    renderer->AddActor(actor);
    context.window().AddRenderer(renderer);
  }

  int height;
  OffscreenContext context;  // first: outlives what is drawn with it
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkContextActor> actor;
};

PlotAreaPainter::PlotAreaPainter(std::array<int, 2> size, int rasteriser_threads)
    : impl_(std::make_unique<Impl>(size, rasteriser_threads)) {}
PlotAreaPainter::~PlotAreaPainter() = default;
std::string PlotAreaPainter::renderer() const { return impl_->context.info().renderer; }

Image PlotAreaPainter::draw(const PlotArea& area) {
  impl_->renderer->SetBackground(area.ground[0] / 255.0, area.ground[1] / 255.0, area.ground[2] / 255.0);
  impl_->renderer->SetBackgroundAlpha(1.0);
  const vtkNew<vtkChartXY> chart;
  chart->SetAutoSize(false);
  chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  const PixelBox& box = area.box;
  chart->SetSize(vtkRectf(static_cast<float>(kSmoothing * box.left),
                          static_cast<float>(kSmoothing * (impl_->height - box.top - box.height)),
                          static_cast<float>(kSmoothing * box.width),
                          static_cast<float>(kSmoothing * box.height)));
  chart->SetShowLegend(false);
  chart->SetTitle("");
  set_axis(*chart->GetAxis(vtkAxis::BOTTOM), area.ticks[0], area);
  set_axis(*chart->GetAxis(vtkAxis::LEFT), area.ticks[1], area);
  // VTK draws no axes round a chart without lines: one that lies on the axis.
  add_line(*chart, {{{0.0, 0.0}, {1.0, 0.0}}, area.axis, area.axis_width, ChartLine::kSolid});
  for (const PlotArea::Line& line : area.lines) add_line(*chart, line);
  const vtkNew<MarkerItem> markers;
  markers->markers = area.markers;
  markers->height = impl_->height;
  vtkContextScene& scene = *impl_->actor->GetScene();
  scene.ClearItems();
  scene.AddItem(chart);
  scene.AddItem(markers);
  return impl_->context.draw(kSmoothing);
}

}  // namespace hydroscope
