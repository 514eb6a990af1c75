// What a Vulkan driver says its pipeline cache holds, kept as a file beside the shader cache.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace anteroom::cache {

// Empty: there is none, or not whole.
std::vector<std::byte> readDriverBlob(const std::filesystem::path& file);
// Replaces the file in one step; a process that is killed leaves the old one. False: it cannot be written.
bool writeDriverBlob(const std::filesystem::path& file, std::span<const std::byte> bytes);
// Removes the files in `folder` whose names begin with `prefix`, but the `most` that were written last.
void keepNewestBlobs(const std::filesystem::path& folder, const std::string& prefix, size_t most);

}  // namespace anteroom::cache
