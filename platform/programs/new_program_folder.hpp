/// A new folder of linked shader programs (program_folder.hpp), which appears complete or not at all: it is written beside its
/// place as "<path>.part" and renamed by commit(). Without that, nothing is left.
///
/// Memory  room for one binary, allocated by open(), and a key a program. Thread  one. Start-up only.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "platform/programs/program_folder.hpp"

namespace tedavis::platform {

class NewProgramFolder final : public base::ProgramStore {
public:
    NewProgramFolder() = default;
    ~NewProgramFolder() override;
    NewProgramFolder(const NewProgramFolder&) = delete;
    NewProgramFolder& operator=(const NewProgramFolder&) = delete;

    /// Fails with one sentence where there is something of that name, or where the folder cannot be made. May be called once.
    [[nodiscard]] base::Error open(std::string_view path);
    [[nodiscard]] bool find(std::uint64_t, base::StoredProgram&) override { return false; }
    [[nodiscard]] base::Span<unsigned char> room(std::size_t bytes) override;
    /// Returns false where the file cannot be written. A program that comes again is written once.
    [[nodiscard]] bool keep(std::uint64_t key, std::string_view name, const base::StoredProgram& program) override;
    /// Puts the folder in its place. Fails with one sentence.
    [[nodiscard]] base::Error commit();
    [[nodiscard]] std::size_t programs() const { return keys_.size(); }

private:
    using FilePath = base::FixedString<1087>;
    [[nodiscard]] FilePath file_of(std::uint64_t key) const;

    base::FixedString<1023> path_, part_;
    std::unique_ptr<unsigned char[]> room_;
    std::vector<std::uint64_t> keys_;
    bool is_open_ = false;
};

}  // namespace tedavis::platform
