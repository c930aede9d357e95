// The verbs that packstone hands over to packstone-pictures.
#pragma once

namespace packstone::cli {

struct PictureVerb {
  const char* name;
  const char* description;
  bool by_ranks = false;  ///< processes that mpirun starts do it together
};

inline constexpr PictureVerb render_verb{"render", "Draw the packing in space: a picture, frames, or a film", true};
inline constexpr PictureVerb slice_verb{"slice", "Draw the true cut of a plane through the packing", true};
inline constexpr PictureVerb plot_verb{
    "plot", "Draw charts over time, over height and over a mixture's ratio, of one or several runs"};
inline constexpr PictureVerb report_verb{"report",
                                         "Write a page with the tables, charts and pictures of a run, or compare runs"};

inline constexpr PictureVerb tradeoff_verb{
    "tradeoff", "Vary a scene's runs, a packing's measures or pictures, and chart error against cost"};

inline constexpr PictureVerb stability_verb{
    "stability", "Sweep steps and parameters and chart where models fail, with theory's limits"};

inline constexpr PictureVerb picture_verbs[] = {render_verb, slice_verb,    plot_verb,
                                                report_verb, tradeoff_verb, stability_verb};

/// Beside packstone.
inline constexpr const char* pictures_program = "packstone-pictures";

}  // namespace packstone::cli
