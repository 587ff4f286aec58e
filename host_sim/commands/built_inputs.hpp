/// What flight tests name and a replay needs as files: terrain, scenes and scenarios that are built, each once.
#pragma once

#include <map>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/flight_test/flight_test.hpp"

namespace tedavis::host_sim {

class BuiltInputs {
public:
    /// They lie in the folder, which must outlive their use. The console must outlive this object.
    BuiltInputs(std::string folder, Console& console) : folder_(std::move(folder)), console_(console) {}

    /// Replaces names in the test by the paths of what was built, and its scenario by a log. Throws UserError for an unknown
    /// name, and Interrupted.
    void resolve(FlightTest& test);
    /// The same, of a test that is then flown: what is interrupted speaks of the test, and not of the files that were built.
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
