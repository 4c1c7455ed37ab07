#pragma once

#include <filesystem>
#include <string>

#include "engine/certificate/certify.h"

namespace furnas {

/// The packing that was certified.
struct CertifiedPacking {
  std::string name;       ///< the folder of its run, or its file
  bool histories = true;  ///< it has the tangential displacements of its contacts
};

/// A certificate as a page of text: each part with its question, its numbers, and what it proves.
std::string certificate_text(const Certificate& certificate, const CertificateTerms& terms,
                             const CertifiedPacking& of);

/// Writes certificate.json and certificate.txt into a folder; throws OutputError.
void write_certificate(const Certificate& certificate, const CertificateTerms& terms,
                       const CertifiedPacking& of, const std::filesystem::path& folder);

}  // namespace furnas
