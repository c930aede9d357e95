// Files that are whole or absent: written under another name, then renamed.
#pragma once

#include <filesystem>
#include <string>

namespace packstone {

/// Name to write under before commit_file; in the same folder, so that the rename is atomic.
std::filesystem::path temporary_name(const std::filesystem::path& target);

/// Renames temporary_name(target) to target. Throws RunError when the disk refuses.
void commit_file(const std::filesystem::path& target);

/// Writes text as a whole file. Throws RunError when the disk refuses.
void write_text_file(const std::filesystem::path& target, const std::string& text);

/// Throws InputError when the file cannot be read.
std::string read_text_file(const std::filesystem::path& path);

}  // namespace packstone
