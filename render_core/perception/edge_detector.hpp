/// Detects edges of a picture: Canny's detector on each of the three colours, and the maximum of the three (thesis, 5.3.2).
///
/// Each channel is blurred by a Gaussian (256ths, rounded once to eight bits, borders repeated), Sobel's 3x3 operator gives the
/// gradient, whose Euclidean length is compared with the thresholds; local maxima across the edge are kept (non-maximum
/// suppression), and of these the pixels above `high` and those above `low` that are connected to them (8-connected
/// hysteresis). A pixel is an edge where it is one in any channel. The thresholds are absolute: a uniform picture has no edges,
/// and noise below them gives none.
///
/// All arithmetic is in integers, so equal pictures give equal edges on every machine. Memory from an arena, at start(). One
/// thread. Bounded by the pixels: each becomes an edge once in each colour.
///
/// Source: Canny 1986; `low` and `high` by default are 0.11 and 0.27 of the gradient of a step from 0 to 255, and sigma is 1, as
/// in Mack and Oliva 2004 and Rosenholtz, Li, Nakano, "Measuring Visual Clutter", Journal of Vision 7 (2007).
#pragma once

#include <cstddef>
#include <cstdint>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"
#include "render_core/perception/edge_rows.hpp"
#include "render_core/perception/picture_view.hpp"

namespace tedavis::perception {

struct CannySettings {
    double sigma = 1;  ///< px, 0 (not blurred) .. kMaxSigma
    double low = 70,
           high = 170;  ///< lengths of Sobel's gradient, 0 <= low <= high; a step of n levels has 4 n before blurring
    [[nodiscard]] bool is_valid() const { return sigma >= 0 && sigma <= kMaxSigma && low >= 0 && low <= high && high <= 32767; }
};

inline constexpr std::uint8_t kEdge = 255;

class EdgeDetector {
public:
    /// Bytes that start() allocates for pictures of at most this size and blurs of at most this sigma.
    [[nodiscard]] static std::size_t bytes(int most_width, int most_height, double most_sigma = kMaxSigma);
    /// Allocates memory; returns false where the arena is too small.
    [[nodiscard]] bool start(base::Arena& arena, int most_width, int most_height, double most_sigma = kMaxSigma);

    /// Returns kEdge or 0 for each pixel, rows from the top without gaps, in the detector's memory, valid until the next picture
    /// begins. Returns nothing where picture or settings are not valid, or larger than at start().
    [[nodiscard]] base::Span<const std::uint8_t> detect(const PictureView& picture, const CannySettings& settings);

    /// The same of a picture that comes in parts, which need not stay: begin(), add_rows() from the top down until there are
    /// `height` rows, finish().
    [[nodiscard]] bool begin(int width, int height, const CannySettings& settings);
    /// Takes the next rows. Returns false, and takes none, where they are not of the picture's width or more than it has left.
    [[nodiscard]] bool add_rows(const PictureView& rows);
    /// Returns the edges, once; nothing where rows are missing.
    [[nodiscard]] base::Span<const std::uint8_t> finish();

private:
    void blur_source(const std::uint8_t* pixels, int channels);
    void blur_row(int y);
    void find_crests_above(int y);
    [[nodiscard]] std::uint8_t* levels(int y) { return levels_.data() + static_cast<std::size_t>(y % 3) * stride_ + kRowLead; }
    [[nodiscard]] GradientRow gradients(int y);
    [[nodiscard]] std::uint16_t* sums(int y);
    void connect();
    void spread_from(std::size_t place);
    void promote(std::size_t place, std::uint8_t strong);

    int most_width_ = 0, most_height_ = 0, sum_rows_ = 1;
    int width_ = 0, height_ = 0;             ///< of the current picture; 0 x 0 where none has begun
    int blurred_across_ = 0, next_row_ = 0;  ///< rows that have been added, and the next one to be blurred downwards
    GaussianWeights weights_;
    EdgeThresholds thresholds_;
    std::size_t stride_ = 0;                              ///< elements of a row of the current picture
    base::Span<std::uint8_t> source_, levels_;            ///< 1 and 3 rows
    base::Span<std::uint16_t> sums_;                      ///< as many rows as the widest blur adds
    base::Span<std::int16_t> across_, down_, neighbors_;  ///< 3, 3 and 2 rows
    base::Span<std::int32_t> squared_;                    ///< 3 rows and one of zeros
    base::Span<std::uint8_t> map_;  ///< weak and strong edges, with a pixel of border round the picture; then what is returned
    base::Span<std::uint32_t> waiting_;  ///< positions in the map whose neighbours remain to be visited
    std::size_t waiting_count_ = 0;
    bool some_were_refused_ = false;
};

}  // namespace tedavis::perception
