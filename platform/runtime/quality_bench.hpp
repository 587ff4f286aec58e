/// Measures quality levels: how much time and how much accuracy a frame has at each combination of the terrain's error, the
/// glyphs' detail, and a number of effects given up, over several pictures of one place.
///
/// The pictures are the program's (BenchDisplays::quality_picture). An effect that runs in none of them, such as one that the
/// device cannot draw, is given up at no level. Effects are given up in the order of the time that they save, divided by the
/// colour difference that they make. The error of a level is the proven bound of the drawn terrain.
///
/// Memory  two pictures, mapped from the system. Thread  one. Failure  one message.
#pragma once

#include "platform/reservation/memory_reservation.hpp"
#include "platform/runtime/bench_frames.hpp"

namespace tedavis::platform {

class QualityBench {
public:
    /// The time that giving up an effect saves, and how much it changes the pictures.
    struct Embellishment {
        effects::Effect effect = effects::Effect::count_;
        bool runs = false;
        double ms = 0, error_color = 0;
    };
    /// Whether one effect is given up before another: first effects that make no difference, then those that save more time for
    /// the difference that they make. A strict weak order.
    [[nodiscard]] static bool comes_before(const Embellishment& a, const Embellishment& b);

    /// The frames' displays are closed. `rounds` frames of every candidate are timed.
    QualityBench(BenchDisplays& displays, BenchFrames& frames, std::uint32_t rounds)
        : displays_(displays), frames_(frames), rounds_(rounds) {}

    /// Measures the candidates, the design's own picture first. `costs` are the measured costs of effects. `done` of `total`
    /// steps are complete; each picture is one more.
    [[nodiscard]] base::Error measure(base::Span<const effects::MeasuredCost> costs, effects::QualityCandidates& candidates,
                                      std::size_t done, std::size_t total);

private:
    using Embellishments = base::FixedVector<Embellishment, effects::kEffectCount>;

    [[nodiscard]] base::Error reserve_pictures();
    [[nodiscard]] base::Error add_contributions(Embellishments& all);
    [[nodiscard]] base::Error add_contribution(Embellishment& one);
    [[nodiscard]] base::Error find_order(base::Span<const effects::MeasuredCost> costs, Embellishments& all);
    [[nodiscard]] base::Error open_sides(const effects::QualityCandidates& candidates);
    [[nodiscard]] base::Error add_picture(effects::QualityCandidates& candidates);
    [[nodiscard]] base::Error add_candidate(std::size_t n, effects::QualityCandidate& candidate);
    [[nodiscard]] double share() const { return 1 / static_cast<double>(displays_.quality_pictures()); }

    BenchDisplays& displays_;
    BenchFrames& frames_;
    std::uint32_t rounds_;
    BenchPicture picture_;  ///< the picture that is measured now
    MemoryReservation reservation_;
    base::Span<std::uint8_t> own_, other_;  ///< the design's own picture, and another one
};

}  // namespace tedavis::platform
