// A file that is replaced as a whole: whoever reads it, even after a kill or a power failure at any moment,
// finds either the old content or the new one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace bondstatic {

/// Whether the new content may lie in a file without a name until it is whole.
enum class UnnamedFiles { where_known, never };

/// Makes `path` hold exactly `content`, on the disk by the time this returns. Only regular files are
/// replaced; behind a symbolic link, the file that it leads to. One writer of a path at a time. A kill may
/// leave the sibling ".NAME.new", which holds the whole new content, or, where the file system knows no
/// unnamed files, ".NAME.part", which does not; the next call removes both. Throws Error (internal), leaving
/// nothing behind.
void replace_file(const std::filesystem::path& path, std::string_view content,
                  UnnamedFiles unnamed_files = UnnamedFiles::where_known);

/// All bytes of a file; nothing where there is none. Throws Error (invalid_input) where it cannot be read.
std::optional<std::string> read_whole_file(const std::filesystem::path& path);

}  // namespace bondstatic
