/// Phase switches on GPIO lines, live.
///
/// Levels are read at open() and returned as the first edges. After every burst of edges they are read again; a level that no
/// edge explains is returned as an edge at the time of reading and counted as an overrun (the kernel buffers 16 edges a line).
/// Stamps are the kernel's: its monotonic clock plus the offset passed to open().
///
/// Thread  one. Memory  inside the object and in libgpiod, all taken by open(); none afterwards. Failure  open() returns one
/// sentence; later the health becomes `failed`, the lines are released, and open() may be called again.
#pragma once

#include <cstdint>
#include <memory>

#include "bus/switches/gpio_lines.hpp"
#include "bus/switches/switch_source.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::bus {

inline constexpr std::size_t kMaxWaitingEdges = 256;

class GpiodSource final : public SwitchSource {
public:
    /// `lines` null means that there is no GPIO library; open() then fails with that message.
    explicit GpiodSource(std::unique_ptr<GpioLines> lines = make_gpiod_lines());
    ~GpiodSource() override;

    struct Opened {};
    /// `now` is the source time of the levels at start; source time = kernel's monotonic clock + `monotonic_to_source`.
    base::Result<Opened, base::Error> open(const SwitchConfig& config, base::Time now, base::Duration monotonic_to_source);
    void close();

    [[nodiscard]] std::size_t read(base::Time until, base::Span<SwitchEdge> out) override;
    [[nodiscard]] SourceHealth health() const override { return health_; }
    [[nodiscard]] const SwitchStatistics& statistics() const override { return statistics_; }

private:
    void collect(std::size_t line, base::Time until);
    [[nodiscard]] std::size_t drain(std::size_t line);
    void keep(const SwitchEdge& edge);
    void fail();

    std::unique_ptr<GpioLines> lines_;
    std::size_t line_count_ = 0;
    base::Duration offset_;
    SwitchLevels seen_;                                        // level of each line's newest edge; unknown after a dropped edge
    base::FixedVector<SwitchEdge, kMaxWaitingEdges> waiting_;  // in order of time
    SwitchStatistics statistics_;
    SourceHealth health_ = SourceHealth::idle;
};

}  // namespace tedavis::bus
