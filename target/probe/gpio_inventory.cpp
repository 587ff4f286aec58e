#include "target/probe/gpio_inventory.hpp"

#include <fcntl.h>
#include <grp.h>
#include <linux/gpio.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace tedavis::target {
namespace {

constexpr int kMaxChipNumber = 256;

base::FixedString<31> owner_group(const char* path) {
    struct stat file {};
    if (::stat(path, &file) != 0) return {};
    const group* const owner = ::getgrgid(file.st_gid);
    return owner != nullptr ? base::FixedString<31>(owner->gr_name) : base::FixedString<31>();
}

base::FixedString<31> kernel_name(const char (&text)[GPIO_MAX_NAME_SIZE]) {
    std::size_t length = 0;
    while (length < GPIO_MAX_NAME_SIZE && text[length] != '\0') ++length;
    return std::string_view(text, length);
}

/// Kernels before 5.10 know the older question only.
bool read_line(int chip, std::uint32_t offset, GpioLine& into) {
    gpio_v2_line_info info{};
    info.offset = offset;
    if (::ioctl(chip, GPIO_V2_GET_LINEINFO_IOCTL, &info) == 0) {
        into = {kernel_name(info.name), kernel_name(info.consumer), (info.flags & GPIO_V2_LINE_FLAG_USED) != 0};
        return true;
    }
    gpioline_info older{};
    older.line_offset = offset;
    if (::ioctl(chip, GPIO_GET_LINEINFO_IOCTL, &older) != 0) return false;
    into = {kernel_name(older.name), kernel_name(older.consumer), (older.flags & GPIOLINE_FLAG_KERNEL) != 0};
    return true;
}

/// False where the file is no GPIO chip.
bool read_chip(int file, GpioChip& into) {
    gpiochip_info info{};
    if (::ioctl(file, GPIO_GET_CHIPINFO_IOCTL, &info) != 0) return false;
    into.label = kernel_name(info.label);
    into.may_open = true;
    into.line_count = info.lines;
    GpioLine line;
    for (std::uint32_t offset = 0; offset < info.lines && read_line(file, offset, line); ++offset)
        if (!into.lines.try_push_back(line)) break;
    return true;
}

void add_chip(GpioInventory& inventory, const char* path, const char* name) {
    const int file = ::open(path, O_RDWR | O_CLOEXEC | O_NONBLOCK);
    const bool is_refused = file < 0 && (errno == EACCES || errno == EPERM);
    if ((file >= 0 || is_refused) && inventory.chips.try_push_back(GpioChip())) {
        GpioChip& chip = inventory.chips.back();
        chip.name = name;
        if (is_refused)
            chip.group = owner_group(path);
        else if (!read_chip(file, chip))
            inventory.chips.pop_back();
    }
    if (file >= 0) ::close(file);
}

}  // namespace

void list_gpio(GpioInventory& inventory, const char* folder) {
    inventory.chips.clear();
    for (int number = 0; number < kMaxChipNumber; ++number) {
        char path[256], name[32];
        std::snprintf(name, sizeof name, "gpiochip%d", number);
        std::snprintf(path, sizeof path, "%s/%s", folder, name);
        add_chip(inventory, path, name);
    }
}

}  // namespace tedavis::target
