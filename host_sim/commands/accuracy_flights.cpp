#include "host_sim/commands/accuracy_flights.hpp"

#include <algorithm>

#include "host_sim/options/replay_options.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

/// The n-th --terrain, or the one for all flights; empty: the shipped one.
std::string terrain_of(const AccuracyOptions& options, std::size_t n) {
    if (options.terrains.empty()) return "";
    return options.terrains.size() == 1 ? options.terrains.front() : options.terrains[n];
}

}  // namespace

void require_pairs(const AccuracyOptions& options) {
    const std::size_t flights = std::max<std::size_t>(1, options.flights.size()), terrains = options.terrains.size();
    if (terrains > 1 && terrains != flights)
        throw UserError("--terrain: was given " + std::to_string(terrains) + " times for " + std::to_string(flights) +
                        (flights == 1 ? " flight" : " flights") + "; give it once, or once for each --flight");
    if (options.switches.size() > options.flights.size())
        throw UserError("--switches " + options.switches.back() +
                        ": has no --flight that it belongs to; give at most one --switches for each --flight");
}

std::vector<MeasuredFlight> read_flights(const AccuracyOptions& options, base::Workers& workers, Console& console) {
    std::vector<MeasuredFlight> flights;
    for (std::size_t n = 0; n < std::max<std::size_t>(1, options.flights.size()); ++n) {
        const std::string given = terrain_of(options, n);
        MeasuredFlight flight;
        flight.terrain = given.empty() ? "the shipped terrain" : given;
        for (const MeasuredFlight& other : flights)
            if (other.terrain == flight.terrain) flight.ground = other.ground;
        if (flight.ground == nullptr)
            flight.ground = std::make_shared<TracedGround>(database_of({given, ""}, options.output, console), workers);
        if (!options.flights.empty()) {
            const ReplayOptions usual;
            const std::string switches = n < options.switches.size() ? options.switches[n] : "";
            flight.recorded = read_recorded_poses({options.flights[n], usual.picture.bus, switches, usual.switch_config},
                                                  flight.ground->path(), console);
        }
        flights.push_back(std::move(flight));
    }
    return flights;
}

}  // namespace tedavis::host_sim
