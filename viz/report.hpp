// report.html: one file with the tables, charts and pictures of a run. Knows nothing of what the numbers mean.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace packstone::viz {

struct ReportTable {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

struct ReportImage {
  std::filesystem::path png;  ///< embedded into the page
  std::string caption;
};

struct ReportSection {
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<ReportTable> tables;
  std::vector<ReportImage> images;
  std::string preformatted;  ///< shown in a fixed-width block that folds; empty for none
};

struct Report {
  std::string title;
  std::string subtitle;
  std::vector<ReportSection> sections;
};

/// Writes the page under another name and renames. It loads nothing from outside and needs no script.
/// Throws RunError when an image is missing or the disk refuses.
void write_report(const std::filesystem::path& path, const Report& report);

}  // namespace packstone::viz
