// The settings of an export, which are kept so that it can be done again.
#pragma once

#include "app/dialogs/export/export_job.h"
#include "app/dialogs/export/export_rows.h"

#include <QStringList>

#include <optional>

class QJsonObject;

namespace suffuse {

/// The endings of files that can be exported: pictures, and layered files.
QStringList exportEndings();
/// The format of the pixels by a path's ending: of OpenRaster, whose layers are PNG files, that; Unknown for other
/// ones.
ImageFormat pixelFormatFor(const QString &path);

struct ExportSettings {
    QString path; ///< absolute path; of a preset only the ending counts
    ImageDepth depth = ImageDepth::Bits8;
    int quality = ImageOptions{}.quality;
    bool transparent = false;
    bool usesProfile = false; ///< whether colours are those of the document's profile, not sRGB
    double dpi = 300;
    AreaRow::Choice area = AreaRow::Choice::Canvas;
    Rect numbers;     ///< the area that was exported, canvas units
    int width = 1;    ///< pixels
    double scale = 1; ///< pixels a unit
    MomentRow::Choice moment = MomentRow::Choice::Dried;
    Microseconds time = 0; ///< the time, if `moment` is one

    /// Whether another export writes the same of a painting, wherever it writes it.
    bool writesAs(const ExportSettings &other) const;
    ImageFormat format() const { return pixelFormatFor(path); }
    /// `profile`: the document's.
    ImageOptions image(const QByteArray &profile) const;
    QJsonObject toJson() const;
    /// Reads settings. Returns none where they are not of this program, or out of range.
    static std::optional<ExportSettings> fromJson(const QJsonObject &object);
    friend bool operator==(const ExportSettings &, const ExportSettings &) = default;
};

/// The order for the same export of the painting as it is now: named areas and moments are looked up anew, and keep
/// their scale. The error says what is missing, or why the picture cannot be made.
Result<ExportOrder> exportOrder(const ExportSettings &settings, Editor &editor, const Rect &shown);

/// What the program remembers of exports. It is not kept in the painting's file, which others may be given.
namespace exports {

/// The settings of the last export of any painting.
std::optional<ExportSettings> last();
/// The settings of the last export of the document at this path. They are forgotten after exports of many other
/// documents.
std::optional<ExportSettings> lastOf(const QString &document);
/// Remembers an export. `document` is empty for a painting that has no file.
void remember(const QString &document, const ExportSettings &settings);

/// The names of the presets, in alphabetical order.
QStringList presets();
std::optional<ExportSettings> preset(const QString &name);
void setPreset(const QString &name, const ExportSettings &settings);
void removePreset(const QString &name);

} // namespace exports

} // namespace suffuse
