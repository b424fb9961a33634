#include "app/session/files/samples.h"

#include "app/session/files/saving_preview.h"
#include "model/formats/files.h"
#include "model/formats/suffuse/suffuse_extras.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <utility>

namespace suffuse {

QStringList sampleFiles()
{
    for (const char *folder : {"../share/suffuse/samples", "../../packaging/samples"}) {
        const QDir dir(QCoreApplication::applicationDirPath() + '/' + QLatin1String(folder));
        QStringList files;
        for (const QString &name : dir.entryList({QStringLiteral("*.suffuse")}, QDir::Files, QDir::Name))
            files << QDir::cleanPath(dir.absoluteFilePath(name));
        if (!files.isEmpty())
            return files;
    }
    return {};
}

QString sampleTitle(const QString &path)
{
    const QString name = QFileInfo(path).completeBaseName();
    static const std::pair<const char *, const char *> titles[] = {
        {"flat", QT_TRANSLATE_NOOP("suffuse::Samples", "Harbour")},
        {"ink-landscape", QT_TRANSLATE_NOOP("suffuse::Samples", "Ink Landscape")},
        {"lanterns", QT_TRANSLATE_NOOP("suffuse::Samples", "Lanterns")},
        {"moonrise", QT_TRANSLATE_NOOP("suffuse::Samples", "Moonrise")},
        {"sheet", QT_TRANSLATE_NOOP("suffuse::Samples", "Sheet of Strokes")},
        {"still-life", QT_TRANSLATE_NOOP("suffuse::Samples", "Still Life")}};
    for (const auto &[file, title] : titles)
        if (name == QLatin1String(file))
            return QCoreApplication::translate("suffuse::Samples", title);
    return name;
}

QImage keptPreview(const QString &path)
{
    constexpr qsizetype aheadOfIt = 1 << 16; // the signature and the chunks that may stand before it
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray bytes = file.read(largestPreview + aheadOfIt);
    if (!startsAsSuffuse(bytes))
        return {};
    for (qsizetype at = suffuseSignatureSize; at < bytes.size();) {
        const auto [chunk, problem] = chunkAt(bytes, at);
        if (!problem.isEmpty())
            return {};
        if (chunk.type == previewType)
            return QImage::fromData(chunk.payload.toByteArray(), "PNG");
        at += chunk.size();
    }
    return {};
}

QImage previewOf(const QString &path, int side)
{
    constexpr qint64 small = 1 << 20; // bytes: it is drawn in a blink
    if (QImage kept = keptPreview(path); !kept.isNull())
        return kept.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    if (const QFileInfo file(path); !file.isFile() || file.size() > small)
        return {};
    Result<LoadedDocument> document = loadDocument(path);
    if (!document)
        return {};
    return previewImage(std::make_shared<const Painting>(std::move(document->painting)), side);
}

} // namespace suffuse
