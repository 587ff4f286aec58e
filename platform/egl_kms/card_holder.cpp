#include "platform/egl_kms/card_holder.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>

#if defined(TEDAVIS_HAVE_KMS)
#include <xf86drm.h>
#endif

#include "render_core/base/driver_scope.hpp"

namespace tedavis::platform {
namespace {

constexpr std::string_view kSeatManagers[] = {"systemd-logind", "seatd"};

bool is_process_number(const char* name) {
    const char* at = name;
    while (std::isdigit(static_cast<unsigned char>(*at)) != 0) ++at;
    return at != name && *at == '\0';
}

bool has_file_open(const char* processes, const char* process, const struct stat& wanted) {
    char folder[300];
    std::snprintf(folder, sizeof folder, "%s/%s/fd", processes, process);
    DIR* const listing = ::opendir(folder);
    if (listing == nullptr) return false;
    bool found = false;
    while (const dirent* const entry = ::readdir(listing)) {
        struct stat open_one {};
        if (::fstatat(dirfd(listing), entry->d_name, &open_one, 0) == 0 && open_one.st_dev == wanted.st_dev &&
            open_one.st_ino == wanted.st_ino && entry->d_name[0] != '.')
            found = true;
    }
    ::closedir(listing);
    return found;
}

base::FixedString<31> name_of_process(const char* processes, const char* process) {
    char path[300], name[32] = "";
    std::snprintf(path, sizeof path, "%s/%s/comm", processes, process);
    const int file = ::open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) return "a program";
    const ssize_t size = ::read(file, name, sizeof name - 1);
    ::close(file);
    std::string_view text(name, size > 0 ? static_cast<std::size_t>(size) : 0);
    text = text.substr(0, text.find('\n'));
    return text.empty() ? std::string_view("a program") : text;
}

void append_holder(const char* processes, const char* process, base::FixedString<191>& holders) {
    const auto name = name_of_process(processes, process);
    for (const std::string_view manager : kSeatManagers)
        if (name.view() == manager) return;
    if (!holders.empty()) holders.append(", ");
    holders.append(name.view());
    holders.append(" (process ");
    holders.append(process);
    holders.append(")");
}

}  // namespace

base::FixedString<191> find_card_holders(const char* path, const char* processes) {
    base::FixedString<191> holders;
    struct stat card {};
    if (::stat(path, &card) != 0) return holders;
    DIR* const listing = ::opendir(processes);
    if (listing == nullptr) return holders;
    char self[16];
    std::snprintf(self, sizeof self, "%d", ::getpid());
    while (const dirent* const entry = ::readdir(listing))
        if (is_process_number(entry->d_name) && std::strcmp(entry->d_name, self) != 0 &&
            has_file_open(processes, entry->d_name, card))
            append_holder(processes, entry->d_name, holders);
    ::closedir(listing);
    return holders;
}

base::Error held_card_error(std::string_view card, std::string_view holders) {
    if (holders.empty()) holders = "a desktop, or another tedavis-display";
    return base::make_error(
        card, ": another program has the screen: ", holders,
        "; end it first, for example with `systemctl stop display-manager` or `systemctl stop tedavis-display`");
}

bool is_card_held([[maybe_unused]] const char* path) {
#if defined(TEDAVIS_HAVE_KMS)
    const base::DriverScope driver;
    const int card = ::open(path, O_RDWR | O_CLOEXEC | O_NONBLOCK);
    if (card < 0) return false;
    const bool is_ours = drmSetMaster(card) == 0 || (errno == EACCES && drmIsMaster(card) != 0);
    if (is_ours) drmDropMaster(card);
    ::close(card);
    return !is_ours;
#else
    return false;
#endif
}

}  // namespace tedavis::platform
