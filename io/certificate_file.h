#pragma once

#include <filesystem>
#include <string>

#include "engine/certificate/certify.h"

namespace furnas {

/// A certificate as a page of text: each part with its question, its numbers, and what it proves. `of` names
/// the packing.
std::string certificate_text(const Certificate& certificate, const CertificateTerms& terms,
                             const std::string& of);

/// Writes certificate.json and certificate.txt into a folder; throws OutputError.
void write_certificate(const Certificate& certificate, const CertificateTerms& terms, const std::string& of,
                       const std::filesystem::path& folder);

}  // namespace furnas
