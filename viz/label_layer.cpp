#include "viz/label_layer.hpp"

#include <utility>

namespace packstone::viz {

bool LabelLayer::kept() const {
  constexpr int largest = 4096;  // [px] a side
  return shown_.still.width <= largest && shown_.still.height <= largest;
}

void LabelLayer::show(Annotation annotation, int supersampling) {
  const bool drawn = whole_.width > 0 && annotation.still == shown_.still && supersampling == supersampling_;
  shown_ = std::move(annotation);
  supersampling_ = supersampling;
  if (!kept()) {
    whole_ = {};
  } else if (!drawn) {
    whole_ = painter_.paint(shown_.still, supersampling);
  }
}

Layer LabelLayer::part(const PixelWindow& window) {
  Layer part = kept() ? part_of(whole_, window) : painter_.paint(shown_.still, window, supersampling_);
  const PixelWindow common = window.common(shown_.changing_in);
  if (common.empty() || shown_.changing.marks.empty()) return part;
  // The time has its place to itself.
  place(part, painter_.paint(shown_.changing, common, supersampling_), common.left - window.left,
        common.top - window.top);
  return part;
}

}  // namespace packstone::viz
