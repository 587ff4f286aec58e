/// Programs made on the desk for a device that has no compiler, kept in memory.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "render_core/base/ports/program_store.hpp"

namespace tedavis::host_sim {

class MadePrograms final : public base::ProgramStore {
public:
    struct Made {
        std::string name;
        std::uint32_t format = 0;
        std::vector<unsigned char> binary;
    };

    [[nodiscard]] bool find(std::uint64_t key, base::StoredProgram& program) override;
    [[nodiscard]] base::Span<unsigned char> room(std::size_t bytes) override;
    [[nodiscard]] bool keep(std::uint64_t key, std::string_view name, const base::StoredProgram& program) override;

    [[nodiscard]] const std::map<std::uint64_t, Made>& all() const { return made_; }

private:
    std::map<std::uint64_t, Made> made_;
    std::vector<unsigned char> room_;
};

}  // namespace tedavis::host_sim
