/// A file that appears complete or not at all: it is written as `<path>.part` and renamed by commit(). Without a commit (an
/// exception, an early return) the part is removed and an existing file at the path is kept.
#pragma once

#include <fstream>
#include <string>
#include <string_view>

namespace tedavis::host_sim {

class AtomicFile {
public:
    /// Throws UserError where the folder cannot be written.
    explicit AtomicFile(std::string path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    [[nodiscard]] std::ostream& stream() { return stream_; }
    /// The path of the part, for libraries that write files by name: they write the whole part, instead of the stream, and close
    /// it before seal() or commit().
    [[nodiscard]] const std::string& part_path() const { return part_; }
    /// Ends the writing. Throws UserError when not every byte could be written.
    void seal();
    /// Seals and puts the file in its place. Throws UserError where that is impossible; then nothing appears. Several files
    /// that belong together are all sealed before the first is committed.
    void commit();

private:
    std::string path_;
    std::string part_;
    std::ofstream stream_;
    bool sealed_ = false, committed_ = false;
};

/// Writes a file with this text, complete or not at all; throws UserError.
void write_file_atomically(const std::string& path, std::string_view text);
/// Creates the folder and its parents; throws UserError where that is impossible.
void make_folder(const std::string& path);

}  // namespace tedavis::host_sim
