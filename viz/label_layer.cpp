#include "viz/label_layer.hpp"

#include <algorithm>

namespace packstone::viz {

namespace {

/// Puts a layer into another where that is empty.
void insert(Layer& layer, const Layer& part, int left, int top) {
  for (int row = 0; row < part.height; ++row) {
    const auto source = part.rgba.begin() + static_cast<std::ptrdiff_t>(row) * part.width * 4;
    std::copy_n(source, static_cast<std::ptrdiff_t>(part.width) * 4,
                layer.rgba.begin() + (static_cast<std::ptrdiff_t>(top + row) * layer.width + left) * 4);
  }
}

}  // namespace

const Layer& LabelLayer::paint(const Annotation& annotation, int supersampling) {
  if (still_.width == 0 || annotation.still != shown_.still) {
    still_ = still_painter_.paint(annotation.still, supersampling);
    shown_.still = annotation.still;
    labels_ = still_;
  }
  if (!annotation.changing.marks.empty()) {
    insert(labels_, changing_painter_.paint(annotation.changing, supersampling), annotation.left, annotation.top);
  }
  return labels_;
}

}  // namespace packstone::viz
