// Films as numbered pictures.
#include "render/film/film_kinds.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <filesystem>

namespace suffuse {

namespace {

/// The names of numbered files, as "film/%05d.png".
struct FrameNames {
    QString folder, before, after;
    int digits = 1;

    QString nameOf(std::size_t frame) const
    {
        return before + QStringLiteral("%1").arg(qulonglong(frame), digits, 10, QLatin1Char('0')) + after;
    }
};

std::optional<FrameNames> frameNames(const QString &pattern)
{
    static const QRegularExpression number(QStringLiteral("%(?:0?(\\d))?d"));
    const QFileInfo file(pattern);
    const QString name = file.fileName();
    const QRegularExpressionMatch found = number.match(name);
    FrameNames out{file.path(), name.left(found.capturedStart()), name.mid(found.capturedEnd()),
                   std::max(1, found.captured(1).toInt())};
    if (!found.hasMatch() || out.before.contains(QLatin1Char('%')) || out.after.contains(QLatin1Char('%')))
        return std::nullopt;
    return out;
}

/// The frames lie in a folder beside their places until all are whole.
class FrameFolder : public FilmWriter {
public:
    FrameFolder(const FilmOptions &options, const FrameNames &names)
        : m_options(options), m_names(names),
          m_hidden(QDir(names.folder).filePath(QStringLiteral(".suffuse-frames-XXXXXX")))
    {}

    Result<void> check() const
    {
        if (m_hidden.isValid())
            return {};
        return Error{QCoreApplication::translate("Film", "%1: cannot write into this folder. Choose another one.")
                         .arg(m_names.folder)};
    }

    Result<void> write(std::size_t i, const FloatPicture &picture) override
    {
        ImageOptions options = m_options.image;
        // There are as many frames as in an hour of painting, and programs that cut films read any PNG.
        options.quick = true;
        return writeImage(pathOf(i), picture, options);
    }

    Result<void> commit() override
    {
        for (std::size_t i = 0; i < m_options.frames; ++i) {
            const QString path = QDir(m_names.folder).filePath(m_names.nameOf(i + 1));
            std::error_code error;
            std::filesystem::rename(pathOf(i).toStdString(), path.toStdString(), error); // This replaces an older film.
            if (error)
                return Error{QStringLiteral("%1: %2").arg(path, QString::fromLocal8Bit(error.message().c_str()))};
        }
        return {};
    }

private:
    QString pathOf(std::size_t i) const { return m_hidden.filePath(m_names.nameOf(i + 1)); }

    const FilmOptions m_options;
    const FrameNames m_names;
    QTemporaryDir m_hidden;
};

} // namespace

QString problemOfFrames(const QString &pattern)
{
    if (frameNames(pattern))
        return {};
    return QCoreApplication::translate("Film", "frames are numbered files: give a name such as film/%05d.png, or one "
                                               "that ends in .webp, .webm or .mp4");
}

QString frameName(const QString &pattern, std::size_t number)
{
    const std::optional<FrameNames> names = frameNames(pattern);
    return names ? QDir(names->folder).filePath(names->nameOf(number)) : QString();
}

Result<std::unique_ptr<FilmWriter>> openFrames(const FilmOptions &options)
{
    auto folder = std::make_unique<FrameFolder>(options, *frameNames(options.path));
    if (const Result<void> checked = folder->check(); !checked)
        return Error{checked.error()};
    return std::unique_ptr<FilmWriter>(std::move(folder));
}

} // namespace suffuse
