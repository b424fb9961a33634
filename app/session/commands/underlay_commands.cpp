#include "app/session/commands/underlay_commands.h"

#include "app/session/editor.h"
#include "app/session/files/picture_file.h"
#include "app/session/files/underlay_image.h"
#include "render/image_io/image_io.h"
#include "undo/underlay_edits.h"

#include <QCoreApplication>
#include <QCursor>
#include <QFile>
#include <QGuiApplication>

namespace suffuse::underlay {

namespace {

struct UnderlayCommands {
    Q_DECLARE_TR_FUNCTIONS(UnderlayCommands)
};

Rect sheetIn(const UnderlayImage &image, const Rect &around)
{
    return fitted(image.size().width(), image.size().height(), around);
}

/// Shows a waiting cursor, since decoding a large picture takes a moment.
Result<UnderlayImagePtr> decodeWaiting(const EncodedImage &encoded, const QString &name)
{
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    Result<UnderlayImagePtr> image = decodeUnderlay(encoded, name);
    QGuiApplication::restoreOverrideCursor();
    return image;
}

} // namespace

bool isPicture(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && detectImageFormat(file.read(64)) != ImageFormat::Unknown;
}

QString importFile(Editor &editor, const QString &path)
{
    const Result<EncodedImage> encoded = readPictureFile(path);
    if (!encoded)
        return encoded.error();
    // This holds the decoded picture until the canvas has it.
    const Result<UnderlayImagePtr> image = decodeWaiting(*encoded, path);
    if (!image)
        return image.error();
    const Document &document = editor.document();
    const auto &before = document.painting()->underlay;
    const Rect place = before && !before->area.isEmpty() ? before->area : document.painting()->canvas.area();
    Underlay underlay = before ? *before : Underlay{};
    underlay.image = *encoded;
    underlay.area = sheetIn(**image, place);
    underlay.visible = true;
    editor.push(setUnderlay(document, underlay),
                before ? UnderlayCommands::tr("Replace underlay") : UnderlayCommands::tr("Import underlay"));
    return {};
}

void show(Editor &editor, bool visible)
{
    editor.push(changeUnderlay(editor.document(), [=](Underlay &u) { u.visible = visible; }),
                visible ? UnderlayCommands::tr("Show underlay") : UnderlayCommands::tr("Hide underlay"));
}

void setOpacity(Editor &editor, double opacity, ValueEntry *entry)
{
    editor.push(changeUnderlay(editor.document(), [=](Underlay &u) { u.opacity = float(opacity); }),
                UnderlayCommands::tr("Change underlay opacity"), entry);
}

void setArea(Editor &editor, const Rect &area, ValueEntry *entry)
{
    const auto &underlay = editor.document().painting()->underlay;
    const auto about = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
    const bool moves =
        underlay && about(underlay->area.width(), area.width()) && about(underlay->area.height(), area.height());
    editor.push(changeUnderlay(editor.document(), [&](Underlay &u) { u.area = area; }),
                moves ? UnderlayCommands::tr("Move underlay") : UnderlayCommands::tr("Resize underlay"), entry);
}

void fitToCanvas(Editor &editor)
{
    const auto &underlay = editor.document().painting()->underlay;
    if (!underlay)
        return;
    const Result<UnderlayImagePtr> image = decodeWaiting(underlay->image, UnderlayCommands::tr("Underlay"));
    const Rect canvas = editor.document().painting()->canvas.area();
    // A picture that cannot be decoded keeps the proportions that it has now.
    const Rect area = image                      ? sheetIn(**image, canvas)
                      : underlay->area.isEmpty() ? canvas
                                                 : fitted(underlay->area.width(), underlay->area.height(), canvas);
    editor.push(changeUnderlay(editor.document(), [&](Underlay &u) { u.area = area; }),
                UnderlayCommands::tr("Fit underlay to the canvas"));
}

void remove(Editor &editor)
{
    editor.push(setUnderlay(editor.document(), {}), UnderlayCommands::tr("Remove underlay"));
}

} // namespace suffuse::underlay
