#include "viz/panel_painter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "viz/common_colouring.hpp"
#include "viz/panels.hpp"
#include "viz/quantity.hpp"

namespace packstone::viz {

struct PanelPainter::Panel {
  PixelWindow window;  // of the picture
  std::unique_ptr<ParticlePainter> painter;
};

PanelPainter::PanelPainter(const PictureOptions& options, std::vector<std::string> titles, int columns)
    : options_(options), titles_(std::move(titles)), columns_(panel_columns(columns, titles_.size())) {
  check_picture(options_);
  if (titles_.size() == 1) {
    panels_.push_back({{0, 0, options_.width, options_.height}, std::make_unique<ParticlePainter>(options_)});
  }
}

PanelPainter::~PanelPainter() = default;

// The last panel of the first row has the legend and what stands below it, and is as much wider than the others.
void PanelPainter::lay_out(const std::vector<PanelContent>& contents, const Colouring& colouring) {
  const int count = static_cast<int>(titles_.size()), rows = (count + columns_ - 1) / columns_;
  const double font = font_size(options_.width, options_.height), time = contents.front().particles.snapshot->time;
  times_differ_ = std::any_of(contents.begin(), contents.end(),
                              [&](const PanelContent& content) { return content.particles.snapshot->time != time; });
  PictureOptions common = options_;
  common.fit = Vec3::Zero();
  for (const PanelContent& content : contents) common.fit = common.fit->cwiseMax(content.particles.snapshot->domain.size());
  common.height = options_.height / rows;
  common.time = options_.time && !times_differ_;
  PictureOptions plain = common;
  plain.legend = plain.axes = plain.time = false;
  plain.scale = plain.scale && plain.view.perspective();
  const auto room = [&](PictureOptions own) {
    own.font_scale *= font / font_size(own.width, own.height);
    return static_cast<int>(
        std::ceil(room_beside(own, *contents.front().particles.snapshot, colouring, contents.front().overlay)));
  };
  const int with_legend = room(common), without = room(plain);
  const int seen = (options_.width - with_legend - (columns_ - 1) * without) / columns_;
  if (seen < 1 || common.height < 1) {
    throw InputError(fmt::format("{} panels have no room in {} x {} px", count, options_.width, options_.height));
  }
  panels_.clear();
  for (int k = 0; k < count; ++k) {
    const auto panel = static_cast<std::size_t>(k);
    PictureOptions own = k == columns_ - 1 ? common : plain;
    own.width = seen + (k == columns_ - 1 ? with_legend : without);
    own.font_scale = options_.font_scale * font / font_size(own.width, own.height);
    own.title = lettered(panel, titles_[panel]);
    if (options_.time && times_differ_) own.title += ", " + time_text(contents[panel].particles.snapshot->time);
    const PixelWindow window{k % columns_ * (seen + without), k / columns_ * common.height, own.width, own.height};
    panels_.push_back({window, std::make_unique<ParticlePainter>(own)});
  }
}

void PanelPainter::show(const std::vector<PanelContent>& contents) {
  std::vector<ParticleView> packings;
  for (const PanelContent& content : contents) packings.push_back(content.particles);
  std::vector<Colouring> colourings = colour_together(packings, options_.color, options_.range);
  if (titles_.size() > 1 && (panels_.empty() || times_differ_)) {  // titles tell the times
    lay_out(contents, colourings.front());
  }
  for (std::size_t k = 0; k < panels_.size(); ++k) {
    panels_[k].painter->show(contents[k].particles, contents[k].overlay, std::move(colourings[k]));
  }
}

Image PanelPainter::part(const PixelWindow& window) {
  if (panels_.size() == 1) return panels_.front().painter->part(window);
  const Colour ground = themed(paper, options_.ground);
  Image image{window.width, window.height, std::vector<std::uint8_t>(window.pixels() * 3)};
  for (std::size_t k = 0; k < image.rgb.size(); k += 3) {
    image.rgb[k] = ground.r;
    image.rgb[k + 1] = ground.g;
    image.rgb[k + 2] = ground.b;
  }
  for (const Panel& panel : panels_) {
    const PixelWindow common = window.common(panel.window);
    if (common.empty()) continue;
    const PixelWindow own{common.left - panel.window.left, common.top - panel.window.top, common.width, common.height};
    place(image, panel.painter->part(own), common.left - window.left, common.top - window.top);
  }
  return image;
}

Image PanelPainter::paint(const std::vector<PanelContent>& contents) {
  show(contents);
  return part({0, 0, options_.width, options_.height});
}

}  // namespace packstone::viz
