#include "render_core/gl/gl.hpp"

#include "render_core/gl/guard.hpp"

namespace tedavis::gl {
namespace {

bool allowed_in(CallStage call, Stage stage) {
    switch (stage) {
        case Stage::closed: return false;
        case Stage::start: return true;
        case Stage::run: return call == CallStage::both;
        case Stage::stopped: return call == CallStage::teardown;
    }
    return false;
}

/// The name in core, then with the suffixes of the extensions that brought these calls.
void* find_entry(base::Surface& surface, const char* name) {
    for (const char* suffix : {"", "KHR", "EXT", "OES"}) {
        base::FixedString<47> full("gl");
        full.append(name);
        full.append(suffix);
        if (void* entry = surface.proc_address(full.c_str())) return entry;
    }
    return nullptr;
}

}  // namespace

Gl::~Gl() {
    if (active_gl == this) active_gl = nullptr;
}

base::Result<DriverFacts, base::Error> Gl::open(base::Surface& surface, const effects::DeviceCapability& device) {
    TEDAVIS_CHECK(stage_ == Stage::closed);
    device_ = device;
    state_.rules = device.gl;
    base::Result<DriverFacts, base::Error> facts = probe_driver(surface);
    if (!facts) return facts;
    facts_ = facts.value();
    for (const base::Error& error : {check_names(), check_driver(), load(surface)})
        if (error) return base::fail(error);
    stage_ = Stage::start;
    build_table(stage_, table_);
    activate();
    return facts;
}

void Gl::seal() {
    TEDAVIS_CHECK(stage_ == Stage::start);
    stage_ = Stage::run;
    build_table(stage_, table_);
}

void Gl::retire() {
    TEDAVIS_CHECK(stage_ == Stage::start || stage_ == Stage::run);
    stage_ = Stage::stopped;
    build_table(stage_, table_);
}

void Gl::activate() {
    TEDAVIS_CHECK(stage_ != Stage::closed);
    active_gl = this;
}

const CallTable* Gl::operator->() const {
    TEDAVIS_CHECK(active_gl == this);  // else the call would reach another context
    return &table_;
}

bool Gl::has(CallId call) const { return device_has(device_.gl, call) && provides(facts_, describe(call).origin); }

bool Gl::suffers(DriverFault fault) const {
    const KnownFault& known = known_faults()[static_cast<std::size_t>(fault)];
    for (const effects::FaultName& ignored : device_.gl.ignored_faults)
        if (ignored.view() == known.name) return false;
    return known.shows_on(facts_);
}

const KnownFault* Gl::binaries_fault() const {
    for (const DriverFault fault : {DriverFault::adreno_program_binaries, DriverFault::powervr_program_binaries})
        if (suffers(fault)) return &known_faults()[static_cast<std::size_t>(fault)];
    return nullptr;
}

base::FixedString<383> Gl::driver_text() const {
    base::FixedString<383> text(facts_.renderer.view());
    text.append(", ");
    text.append(facts_.version.view());
    const char* before = "; known faults: ";
    for (const KnownFault& known : known_faults()) {
        if (!suffers(known.fault)) continue;
        text.append(before);
        text.append(known.name);
        before = ", ";
    }
    return text;
}

GLenum Gl::take_error() const {
    constexpr int kMaxPendingErrors = 16;  // a lost context may report for ever
    const GLenum first = (*this)->GetError();
    GLenum next = first;
    for (int i = 0; i < kMaxPendingErrors && next != GL_NO_ERROR; ++i) next = (*this)->GetError();
    return first;
}

base::Error Gl::check_names() const {
    for (const auto* names : {&device_.gl.also, &device_.gl.never})
        for (const effects::CallName& name : *names)
            if (find_call(name.view()) == CallId::count)
                return base::make_error("the device file names the GL call '", name.view(),
                                        "', which the call table does not know; remove it");
    for (const effects::FaultName& name : device_.gl.ignored_faults)
        if (find_fault(name.view()) == DriverFault::count)
            return base::make_error("the device file ignores the driver fault '", name.view(),
                                    "', which nobody knows; remove it");
    return {};
}

base::Error Gl::check_driver() const {
    if (facts_.depth_bits < static_cast<std::int32_t>(device_.surface_depth_bits))
        return base::make_error("the surface has ", base::digits(static_cast<std::uint64_t>(facts_.depth_bits)).view(),
                                " depth bits and the device asks for more; choose another surface or device");
    if (device_.depth24_targets && !facts_.depth24_targets)
        return base::make_error("the driver ", facts_.version.view(),
                                " has no OES_depth24, which the device asks for; choose another device");
    if (facts_.max_texture_px < static_cast<std::int32_t>(device_.gl.max_texture_px) ||
        facts_.max_attributes < static_cast<std::int32_t>(device_.gl.max_attributes) ||
        facts_.max_texture_units < static_cast<std::int32_t>(device_.gl.max_texture_units))
        return base::make_error("the driver ", facts_.version.view(),
                                " has smaller limits than the device file's [gl] table; choose another device");
    return {};
}

base::Error Gl::load(base::Surface& surface) {
#define TEDAVIS_GL_CALL(result, name, arguments, devices, stage, origin)                                 \
    if (device_has(device_.gl, CallId::name)) {                                                          \
        loaded_.name = reinterpret_cast<decltype(loaded_.name)>(find_entry(surface, #name));             \
        if (loaded_.name == nullptr || !provides(facts_, CallOrigin::origin))                            \
            return base::make_error("the driver ", facts_.version.view(),                                \
                                    " lacks gl" #name ", which the device uses; choose another device"); \
    }
#include "render_core/gl/gl_calls.inc"
#undef TEDAVIS_GL_CALL
    return {};
}

void Gl::build_table(Stage at, CallTable& table) const {
#define TEDAVIS_GL_CALL(result, name, arguments, devices, stage, origin)                                                   \
    table.name = device_has(device_.gl, CallId::name) && allowed_in(CallStage::stage, at) ? &Guard<&CallTable::name>::call \
                                                                                          : &Deny<&CallTable::name>::call;
#include "render_core/gl/gl_calls.inc"
#undef TEDAVIS_GL_CALL
}

void Gl::refuse(CallId call, const char* reason) {
    ++denied_.total;
    for (DeniedCall& known : denied_.first) {
        if (known.call != call || known.reason != reason) continue;
        ++known.count;
        return;
    }
    // A full list keeps the total right; the first kinds are what a reader needs.
    static_cast<void>(denied_.first.try_push_back({call, reason, 1}));
}

const char* Gl::absence(CallId call) const {
    if (!device_has(device_.gl, call)) return "the device does not have the call";
    return stage_ == Stage::run ? "a start-up call after the start" : "only deletion is left after the run";
}

}  // namespace tedavis::gl
