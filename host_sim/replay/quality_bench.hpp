/// Measures quality levels: how much time and how much accuracy a frame has at each combination of the terrain's error, the
/// glyphs' detail, and a number of effects given up, over several pictures of one place.
///
/// The pictures are the caller's design with all effects of color and geometry that may be given up, as far as they can be added
/// to it, and designs for what it may lack: glyphs of fields, blur round a focus, a view of saliency. An effect that runs in none
/// of them, such as one that the device cannot do, is given up at no level. Effects are given up in the order of the time that
/// they save by the difference of color that they make.
#pragma once

#include <functional>

#include "host_sim/measure/quality_front.hpp"
#include "host_sim/replay/bench_frames.hpp"
#include "host_sim/reports/calibration_file.hpp"

namespace tedavis::host_sim {

class QualityBench {
public:
    static constexpr std::size_t kPictures = 4;

    QualityBench(const BenchPlace& place, std::uint32_t rounds) : place_(place), rounds_(rounds) {}

    /// Returns the candidates, the design's own picture first. `costs` are the measured costs of effects. `progress()` is called
    /// after each picture and may throw. Throws UserError where a display cannot be opened.
    [[nodiscard]] std::vector<QualityCandidate> measure(const std::vector<MeasuredCost>& costs,
                                                        const std::function<void()>& progress) const;

private:
    [[nodiscard]] std::vector<PictureOptions> pictures() const;
    [[nodiscard]] std::vector<effects::Effect> given_up_order(const std::vector<MeasuredCost>& costs) const;
    void add_picture(const PictureOptions& picture, std::vector<QualityCandidate>& candidates) const;

    BenchPlace place_;
    std::uint32_t rounds_;
};

}  // namespace tedavis::host_sim
