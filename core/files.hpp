// Files that are whole or absent: written under another name, then renamed.
#pragma once

#include <filesystem>
#include <string>

namespace packstone {

/// Name to write under before commit_file; in the same folder, so that the rename is atomic.
std::filesystem::path temporary_name(const std::filesystem::path& target);

/// Renames temporary_name(target) to target. Throws RunError when the disk refuses; the temporary file is gone then.
void commit_file(const std::filesystem::path& target);

/// Removes temporary_name(target) where it is there.
void discard_temporary(const std::filesystem::path& target);

/// Before long work whose file comes at its end. Throws InputError when target is a folder or empty, RunError when no
/// file can be made beside it.
void check_writable(const std::filesystem::path& target);

/// Writes text as a whole file. Throws RunError when the disk refuses.
void write_text_file(const std::filesystem::path& target, const std::string& text);

/// Throws InputError when the file cannot be read.
std::string read_text_file(const std::filesystem::path& path);

}  // namespace packstone
