// Reads manifests of extensions (docs/extensions.md, "The manifest").
#pragma once

#include "app/extensions/extension.h"
#include "model/result.h"

namespace suffuse {

inline constexpr int manifestVersion = 1;
inline const QString manifestName = QStringLiteral("manifest.json");

/// Reads a manifest. `path` names it in messages, and its folder is that of the extension. Errors name the file, the
/// member and what is wrong with it.
Result<Extension> readManifest(const QByteArray &bytes, const QString &path);

} // namespace suffuse
