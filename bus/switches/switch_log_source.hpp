/// A recorded switch log (bus/switches/switch_log.hpp) as a source of edges.
///
/// Thread  one. Memory  the caller's text, which must outlive the source. Failure  broken lines are counted; the first
/// kMaxSwitchLineReports are kept with line number and reason.
#pragma once

#include <cstdint>
#include <string_view>

#include "bus/switches/switch_log.hpp"
#include "bus/switches/switch_source.hpp"
#include "render_core/base/fixed_vector.hpp"

namespace tedavis::bus {

inline constexpr std::size_t kMaxSwitchLineReports = 32;

struct SwitchLineReport {
    std::uint64_t line = 0;  ///< counted from 1
    SwitchLineFault fault = SwitchLineFault::none;
};

class SwitchLogSource final : public SwitchSource {
public:
    SwitchLogSource(std::string_view text, const SwitchConfig& config) : config_(config), text_(text) {}

    [[nodiscard]] std::size_t read(base::Time until, base::Span<SwitchEdge> out) override;
    [[nodiscard]] SourceHealth health() const override;
    [[nodiscard]] const SwitchStatistics& statistics() const override { return statistics_; }
    [[nodiscard]] base::Span<const SwitchLineReport> reports() const { return {reports_.data(), reports_.size()}; }
    /// Restarts at the beginning of the text with all counts at zero.
    void restart() { *this = SwitchLogSource(text_, config_); }

private:
    /// Reads the next edge into `next_` unless one is there; returns false at the end of the text.
    [[nodiscard]] bool fetch();
    void count(const SwitchLogLine& line);

    SwitchConfig config_;
    std::string_view text_;
    std::size_t at_ = 0;
    std::uint64_t line_number_ = 0;
    SwitchEdge next_;
    bool next_waits_ = false;
    base::Time newest_;
    SwitchStatistics statistics_;
    base::FixedVector<SwitchLineReport, kMaxSwitchLineReports> reports_;
};

}  // namespace tedavis::bus
