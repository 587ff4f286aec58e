/// Saliency by the spectral residual, a measure independent of saliency_model.hpp: the deviation of a picture's log spectrum
/// from its smoothed one.
///
/// The luma of a picture, averaged to 64 x 64 whatever its shape; R = log|F| - mean of 3 x 3 of it (the spectrum is periodic);
/// the map is the Gaussian mean (kResidualSigma_px) of |inverse(exp(R) F / |F|)|^2, divided by its maximum. A uniform picture
/// has a map of zeros.
///
/// Double precision; elementary functions are the C library's, so that maps of two machines agree to 1e-9, not to the bit.
/// Memory from an arena, at start(). One thread.
///
/// Source: X. Hou, L. Zhang, "Saliency Detection: A Spectral Residual Approach", CVPR 2007.
#pragma once

#include <array>
#include <complex>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"
#include "render_core/perception/picture_view.hpp"

namespace tedavis::perception {

inline constexpr int kResidualSide = 64;
inline constexpr double kResidualSigma_px = 2.5;

/// Direction of the in-place Fourier transform of 64 numbers; forwards has no factor, backwards divides by 64.
enum class TransformDirection { forwards, backwards };
void fourier_transform(base::Span<std::complex<double>> numbers, TransformDirection way) noexcept;

class SpectralResidual {
public:
    [[nodiscard]] static std::size_t bytes();
    [[nodiscard]] bool start(base::Arena& arena);
    /// Computes the map; returns false where the picture is not valid.
    [[nodiscard]] bool look(const PictureView& picture);
    /// Returns the map of the last picture: 64 x 64 values 0..1, rows from the top.
    [[nodiscard]] base::Span<const float> values() const { return values_; }
    [[nodiscard]] bool has_salient() const { return has_salient_; }

private:
    void transform(TransformDirection way);
    void take_residual();
    void blur_power();

    base::Span<std::complex<double>> spectrum_;
    base::Span<double> numbers_;  ///< log of the spectrum, then power
    base::Span<float> values_;
    bool has_salient_ = false;
};

}  // namespace tedavis::perception
