#include "host_sim/replay/made_programs.hpp"

namespace tedavis::host_sim {

bool MadePrograms::find(std::uint64_t key, base::StoredProgram& program) {
    const auto found = made_.find(key);
    if (found == made_.end()) return false;
    program = {found->second.format, found->second.binary};
    return true;
}

base::Span<unsigned char> MadePrograms::room(std::size_t bytes) {
    room_.resize(bytes);
    return room_;
}

bool MadePrograms::keep(std::uint64_t key, std::string_view name, const base::StoredProgram& program) {
    made_[key] = {std::string(name), program.format, {program.binary.begin(), program.binary.end()}};
    return true;
}

}  // namespace tedavis::host_sim
