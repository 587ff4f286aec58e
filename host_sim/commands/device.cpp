#include "host_sim/commands/device.hpp"

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/start_trial.hpp"
#include "host_sim/device_plan/device_text.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

/// Largest first. The lane of a smaller memory is es2.
constexpr const char* kPlannedFrom[] = {"desktop", "es3-mid", "es2-small"};
constexpr std::size_t kMaxName = 31;

std::vector<effects::DeviceSettings> shipped_of(std::optional<effects::Lane> lane) {
    std::vector<effects::DeviceSettings> devices;
    for (const char* const name : kPlannedFrom) {
        PictureOptions options;
        options.device = name;
        const effects::DeviceSettings device = load_device(options);
        if (!lane || device.capability.lane == *lane) devices.push_back(device);
    }
    return devices;
}

/// The file's name, where a device may have it.
std::string device_name(const std::string& output) {
    const std::string stem = std::filesystem::path(output).stem().string();
    bool is_plain = !stem.empty() && stem.size() <= kMaxName;
    for (const char c : stem) is_plain = is_plain && (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_');
    return is_plain ? stem : "planned";
}

DeviceAsk ask_of(const DevicePlanOptions& options) {
    if (std::filesystem::path(options.output).extension() != ".toml")
        throw UserError("-o " + options.output + ": a device is a TOML file; give it a name that ends in .toml");
    if (!(options.rate_hz >= 1 && options.rate_hz <= 240)) throw UserError("--rate: a device draws 1 to 240 pictures a second");
    constexpr std::uint32_t kFewestPixels = 64;
    const PictureSize size = options.picture.size.value_or(PictureSize{});
    if (size.width < kFewestPixels || size.height < kFewestPixels)
        throw UserError("--size: the edges of a device's picture have 64 pixels or more");
    return {device_name(options.output), size, options.rate_hz, memory_from(options.memory), options.memory};
}

/// On one line and in ASCII, whatever names hold: a TOML file takes no other bytes than those of UTF-8.
std::string plan_command(const DevicePlanOptions& options, const DeviceAsk& ask) {
    char rate[32];
    std::snprintf(rate, sizeof rate, "%g", ask.rate_hz);
    std::string text = "tedavis device plan --size " + std::to_string(ask.size.width) + "x" + std::to_string(ask.size.height) +
                       " --memory " + options.memory + " --rate " + rate + " --design " + options.picture.design;
    if (!options.picture.scene.empty()) text += " --scene " + options.picture.scene;
    if (!options.picture.terrain.empty()) text += " --terrain " + options.picture.terrain;
    if (options.lane) text += std::string(" --lane ") + effects::to_string(*options.lane);
    text += " -o " + options.output;
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
    return text;
}

/// What a file says of its own making.
std::string comment_of(const DevicePlan& plan, const std::string& command) {
    std::string text = "Written by: " + command + "\n";
    text += "Made from " + plan.shipped + ": " + std::to_string(total_bytes(plan.device)) +
            " bytes of processor and GPU together. A display has started on it.";
    for (const GivenUp& one : plan.given_up) text += "\nGiven up: " + one.sentence + ".";
    return text;
}

/// Starts displays on devices that are not written yet.
class PlanTrial {
public:
    explicit PlanTrial(const PictureOptions& picture) : picture_(picture) {
        picture_.size.reset();
        picture_.device = folder_.path() + "/device.toml";
    }

    [[nodiscard]] StartedDevice start(const effects::DeviceSettings& device) {
        if (interrupt_.requested()) throw Interrupted("device plan: stopped; nothing was written");
        write_file_atomically(picture_.device, device_text(device, ""));
        try {
            StartTrial::Outcome outcome = trial_.start(picture_);
            return {outcome.shortage, outcome.used};
        } catch (const UserError& error) {
            const std::string message = error.what(), file = picture_.device + ": ";
            const bool is_of_device = message.compare(0, file.size(), file) == 0;
            throw UserError(is_of_device ? "the planned device does not start: " + message.substr(file.size()) : message);
        }
    }

private:
    InterruptGuard interrupt_;
    TemporaryFolder folder_;
    StartTrial trial_;
    PictureOptions picture_;
};

}  // namespace

std::uint64_t memory_from(const std::string& text) {
    constexpr double kMaxBytes = 1e15;
    char* end = nullptr;
    const bool is_number = !text.empty() && (std::isdigit(static_cast<unsigned char>(text[0])) != 0);
    const double number = is_number ? std::strtod(text.c_str(), &end) : 0;
    const std::string unit = is_number ? std::string(end) : "?";
    const double factor = unit.empty() ? 1 : unit == "K" ? 1024.0 : unit == "M" ? 1048576.0 : unit == "G" ? 1073741824.0 : 0;
    const double bytes = number * factor;
    if (!(bytes >= 1 && bytes <= kMaxBytes))
        throw UserError("--memory " + text + ": not a number of bytes, or of K, M or G (1024, 1024 x 1024, ...), such as 64M");
    return static_cast<std::uint64_t>(bytes);
}

int run_device_plan(const DevicePlanOptions& options, Console& console) {
    const DeviceAsk ask = ask_of(options);
    const DeviceNeeds needs = device_needs(options.picture);
    AtomicFile file(options.output);
    PlanTrial trial(options.picture);
    const auto start = [&](const effects::DeviceSettings& device) { return trial.start(device); };
    const DevicePlan plan = plan_device(shipped_of(options.lane), ask, needs, start);
    file.stream() << device_text(plan.device, comment_of(plan, plan_command(options, ask)));
    file.commit();
    nlohmann::ordered_json json = {{"file", options.output}};
    json.update(plan_json(plan, ask.memory_bytes));
    console.result(options.output + ": " + plan_text(plan, ask.memory_bytes), json_text(json));
    return 0;
}

}  // namespace tedavis::host_sim
