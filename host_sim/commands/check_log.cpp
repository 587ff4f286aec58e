#include "host_sim/commands/check_log.hpp"

#include "host_sim/input_file.hpp"
#include "host_sim/replay/log_facts.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

bus::BusSettings bus_named(const std::string& name) {
    const std::string path = resolve_config(name, "buses");
    const auto settings = bus::load_bus_settings(read_file(path), path);
    if (!settings.ok()) throw UserError(std::string(settings.error().message.view()));
    return settings.value();
}

}  // namespace

CheckedFile check_log(const std::string& path, const std::string& bus) {
    const LogFacts facts = read_log_facts(path, bus_named(bus));
    std::string is = "a candump log of " + counted(facts.counters.frames, "frame") + ", of which the bus " + bus + " decodes " +
                     std::to_string(facts.counters.decoded);
    if (facts.lines.other > 0)
        is += ", " + std::to_string(facts.lines.other) + (facts.lines.other == 1 ? " line that does not" : " lines that do not") +
              " begin with '('";
    return {is, log_findings(path, bus, facts)};
}

}  // namespace tedavis::host_sim
