/// The only access to GL: `gl->Clear(...)` calls through a table that contains only the calls that the device file allows.
///
/// A call that the device does not have, or not in this stage, or not with these arguments, is not executed: it returns zero
/// and is counted under its name. Stages follow in this order: start (creation, compilation, storage), run (after seal()),
/// stopped (after retire(), deletion only).
///
/// Thread    one; the surface must be current. Memory  none; driver calls are marked with base::DriverScope.
/// Lifetime  one Gl per context; it must not outlive its surface. Not movable: the guards use a pointer to the thread's active
/// Gl.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render_core/base/error.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/ports/program_store.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/base/result.hpp"
#include "render_core/effects/device_capability.hpp"
#include "render_core/gl/call_rules.hpp"
#include "render_core/gl/call_table.hpp"
#include "render_core/gl/capability_probe.hpp"
#include "render_core/gl/driver_fault.hpp"

namespace tedavis::gl {

enum class Stage : std::uint8_t { closed, start, run, stopped };

struct DeniedCall {
    CallId call = CallId::count;
    const char* reason = "";  ///< static text
    std::uint64_t count = 0;
};
inline constexpr std::size_t kMaxDeniedKinds = 32;

/// Calls outside the device: a defect, never an event of normal operation.
struct DeniedReport {
    std::uint64_t total = 0;
    base::FixedVector<DeniedCall, kMaxDeniedKinds> first;  ///< the first kinds of (call, reason), in order of appearance
};

class Gl {
public:
    Gl() = default;
    ~Gl();
    Gl(const Gl&) = delete;
    Gl& operator=(const Gl&) = delete;

    /// Loads the table for the current surface and makes this Gl the thread's active one, in the start stage. Refuses a
    /// driver that lacks an allowed call or is below the device's requirements, and a device file that names no call.
    [[nodiscard]] base::Result<DriverFacts, base::Error> open(base::Surface& surface, const effects::DeviceCapability& device);
    /// Sets the store of linked programs: read on a device without a shader compiler, filled on one that has it; null for none.
    /// May be called before or after open(); the store must outlive the start stage.
    void use_programs(base::ProgramStore* store) { programs_ = store; }
    [[nodiscard]] base::ProgramStore* programs() const { return programs_; }
    /// Ends the start stage for good.
    void seal();
    /// Ends the run stage: only deletion is allowed from here.
    void retire();
    /// Makes this the thread's active Gl again, after another surface was current.
    void activate();

    [[nodiscard]] const CallTable* operator->() const;
    [[nodiscard]] Stage stage() const { return stage_; }
    [[nodiscard]] const effects::DeviceCapability& device() const { return device_; }
    [[nodiscard]] const DriverFacts& driver() const { return facts_; }
    /// True where the driver has a known fault that the device file does not ignore.
    [[nodiscard]] bool suffers(DriverFault fault) const;
    /// The fault that forbids program binaries, or null.
    [[nodiscard]] const KnownFault* binaries_fault() const;
    /// The driver's names, and its known faults with workarounds.
    [[nodiscard]] base::FixedString<383> driver_text() const;
    [[nodiscard]] const DeniedReport& denied() const { return denied_; }
    /// True where the device's list contains the call and the driver has it.
    [[nodiscard]] bool has(CallId call) const;

    void begin_frame() { state_.frame = {}; }
    [[nodiscard]] const FrameCounts& frame() const { return state_.frame; }
    /// Returns the first pending GL error, 0 for none, and clears all.
    [[nodiscard]] GLenum take_error() const;

private:
    template <auto Member>
    friend struct Guard;
    template <auto Member>
    friend struct Deny;

    [[nodiscard]] base::Error check_names() const;
    [[nodiscard]] base::Error check_driver() const;
    [[nodiscard]] base::Error load(base::Surface& surface);
    void build_table(Stage stage, CallTable& table) const;
    void refuse(CallId call, const char* reason);
    [[nodiscard]] const char* absence(CallId call) const;

    effects::DeviceCapability device_;
    base::ProgramStore* programs_ = nullptr;
    DriverFacts facts_;
    CallTable loaded_{};  ///< the driver's entry points
    CallTable table_{};   ///< the table that callers use: guards and denials
    CallState state_;
    DeniedReport denied_;
    Stage stage_ = Stage::closed;
};

}  // namespace tedavis::gl
