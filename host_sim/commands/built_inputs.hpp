/// Builds the terrains, scenes and scenarios that flight tests name, each once, since a replay needs them as files.
#pragma once

#include <map>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/flight_test/flight_test.hpp"

namespace tedavis::host_sim {

class BuiltInputs {
public:
    /// The files are written to the folder, which must exist while they are used. The console must outlive this object.
    BuiltInputs(std::string folder, Console& console) : folder_(std::move(folder)), console_(console) {}

    /// Replaces names in the test by the paths of what was built, and its scenario by a log. Throws UserError for an unknown
    /// name, and Interrupted.
    void resolve(FlightTest& test);
    /// The same for a test that is flown next: the message of an interruption is about the test, not about the files.
    void resolve_to_fly(FlightTest& test);

private:
    template <class Build>
    std::string built(const std::string& name, Build build);
    std::string terrain(const std::string& name);
    std::string scene(const std::string& name);
    void take_scenario(FlightTest& test);

    std::string folder_;
    Console& console_;
    std::map<std::string, std::string> built_;
};

}  // namespace tedavis::host_sim
