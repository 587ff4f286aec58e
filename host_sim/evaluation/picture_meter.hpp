/// Measures pictures one after another and reuses its memory, which grows to that of the largest.
///
/// Equal pictures give equal numbers, independent of earlier ones. Thread  one per meter.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host_sim/evaluation/evaluation_views.hpp"
#include "host_sim/evaluation/picture_measures.hpp"
#include "host_sim/layer_mask.hpp"
#include "render_core/perception/saliency_model.hpp"
#include "render_core/perception/spectral_residual.hpp"

namespace tedavis::host_sim {

class PictureMeter {
public:
    explicit PictureMeter(const EvaluationSettings& settings) : settings_(settings) {}

    /// `mask` may be null. Throws UserError for a picture larger than perception::kMaxPictureSide, which `name` names.
    [[nodiscard]] PictureMeasures measure(const RgbaPicture& picture, const std::string& name, const LayerMask* mask,
                                          const std::vector<GazePixel>& gaze);

    /// Returns the edges of the picture measured last, one byte per pixel.
    [[nodiscard]] const std::vector<std::uint8_t>& edges() const { return edges_; }
    /// Returns its saliency, one value per pixel of the picture, on the picture's own scale.
    [[nodiscard]] FloatMap saliency();
    /// Returns the same at the model's resolution; valid until the next picture.
    [[nodiscard]] perception::SaliencyMap saliency_map() { return model_.map(perception::SaliencyScale::per_picture); }
    /// Returns the saliency of a picture by the spectral residual (perception/spectral_residual.hpp), in the same form.
    [[nodiscard]] FloatMap second_opinion(const RgbaPicture& picture);

private:
    void make_room(int width, int height);
    void measure_edges(const perception::PictureView& view, PictureMeasures& measures);
    void measure_saliency(const perception::PictureView& view, const LayerMask* mask, PictureMeasures& measures);

    EvaluationSettings settings_;
    std::vector<std::byte> memory_, opinion_memory_;
    perception::EdgeDetector detector_;
    perception::SaliencyModel model_;
    perception::SpectralResidual opinion_;
    int most_width_ = 0, most_height_ = 0;
    std::uint32_t width_ = 0, height_ = 0;
    std::vector<std::uint8_t> edges_;
};

}  // namespace tedavis::host_sim
