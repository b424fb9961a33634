#include "render/tiles/tile_store.h"

#include "render/image_io/file_replacement.h"
#include "render/tiles/deep_zoom_page.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

namespace suffuse {

SheetRecord sheetRecord(qint64 number, qint64 offset, const std::vector<QByteArray> &tiles)
{
    SheetRecord record{number, offset, {}, {}};
    for (const QByteArray &tile : tiles) {
        record.sizes.push_back(quint32(tile.size()));
        record.hashes.push_back(tileHash(tile));
    }
    return record;
}

Result<void> replaceFile(const QString &path, const QByteArray &bytes, bool toDisk)
{
    FileReplacement file(path);
    if (Result<void> opened = file.open(); !opened)
        return opened;
    file.write(bytes.constData(), std::size_t(bytes.size()), 0);
    return file.commit(toDisk);
}

namespace {

QString endingOf(TileFormat format)
{
    return format == TileFormat::Jpeg ? QStringLiteral("jpg") : QStringLiteral("png");
}

} // namespace

std::optional<LostFile> lostFile(const QString &path, const std::function<bool(const QByteArray &)> &isGood)
{
    QFile file(path);
    const bool isThere = file.open(QIODevice::ReadOnly);
    if (isThere && isGood(file.readAll()))
        return {};
    return LostFile{path, isThere};
}

bool isWhole(const SheetRecord &record, QByteArrayView tiles)
{
    qsizetype at = 0;
    for (std::size_t i = 0; i < record.sizes.size(); ++i) {
        const auto size = qsizetype(record.sizes[i]);
        if (size == 0 || tiles.size() - at < size || tileHash(tiles.sliced(at, size)) != record.hashes[i])
            return false;
        at += size;
    }
    return at == tiles.size();
}

DeepZoomStore::DeepZoomStore(const TiledPicture &picture, SheetRecords records, TileJournal &journal, qint64 base)
    : m_picture(picture), m_records(std::move(records)), m_journal(journal), m_base(base),
      m_files(filesOf(picture.path))
{}

QString DeepZoomStore::filesOf(const QString &path)
{
    return path.left(path.size() - 4) + QStringLiteral("_files");
}

QString DeepZoomStore::pageOf(const QString &path)
{
    return path.left(path.size() - 4) + QStringLiteral(".html");
}

bool DeepZoomStore::isPageTaken(const QString &path)
{
    QFile page(pageOf(path));
    return page.exists() && !(page.open(QIODevice::ReadOnly) && isDeepZoomPage(page.read(4096)));
}

QString DeepZoomStore::pathOf(int level, int column, int row) const
{
    return QStringLiteral("%1/%2/%3_%4.%5")
        .arg(m_files)
        .arg(level)
        .arg(column)
        .arg(row)
        .arg(endingOf(m_picture.encoding.format));
}

bool DeepZoomStore::has(qint64 number)
{
    const auto [from, to] = m_records.equal_range(number);
    if (from == to)
        return false;
    const TileSheet sheet = m_picture.plan.sheet(number);
    QByteArray tiles;
    for (int row = 0; row < sheet.rows; ++row)
        for (int column = 0; column < sheet.columns; ++column) {
            QFile file(pathOf(sheet.level, sheet.column + column, sheet.row + row));
            if (!file.open(QIODevice::ReadOnly))
                return false;
            tiles += file.readAll();
        }
    return std::any_of(from, to, [&](const auto &record) { return isWhole(record.second, tiles); });
}

std::vector<LostFile> DeepZoomStore::lost(qint64 number) const
{
    const auto [from, to] = m_records.equal_range(number);
    const TileSheet sheet = m_picture.plan.sheet(number);
    std::vector<LostFile> files;
    for (std::size_t i = 0; i < std::size_t(sheet.columns) * std::size_t(sheet.rows); ++i) {
        const int column = sheet.column + int(i) % sheet.columns, row = sheet.row + int(i) / sheet.columns;
        const auto isGood = [&, from = from, to = to](const QByteArray &bytes) {
            return std::any_of(from, to, [&](const auto &record) {
                const SheetRecord &said = record.second;
                return i < said.sizes.size() && bytes.size() == qsizetype(said.sizes[i]) &&
                       tileHash(bytes) == said.hashes[i];
            });
        };
        if (auto file = lostFile(pathOf(sheet.level, column, row), isGood))
            files.push_back(std::move(*file));
    }
    return files;
}

Result<void> DeepZoomStore::putTile(const TileSheet &sheet, std::size_t index, const QByteArray &tile)
{
    const int column = sheet.column + int(index) % sheet.columns, row = sheet.row + int(index) / sheet.columns;
    // Where the level's folder cannot be made, the tile says why. A folder that vanished stays away.
    QDir().mkdir(QStringLiteral("%1/%2").arg(m_files).arg(sheet.level));
    return replaceFile(pathOf(sheet.level, column, row), tile, false);
}

Result<void> DeepZoomStore::put(const TileSheet &, qint64 number, const std::vector<QByteArray> &tiles)
{
    return m_journal.add(sheetRecord(m_base + number, 0, tiles));
}

Result<void> DeepZoomStore::finish()
{
    // What workers that were killed left behind.
    for (std::size_t level = 0; level < m_picture.plan.levels().size(); ++level) {
        QDir folder(QStringLiteral("%1/%2").arg(m_files).arg(level));
        for (const QString &name : folder.entryList({QStringLiteral(".suffuse-*.tmp")}, QDir::Files | QDir::Hidden))
            folder.remove(name);
    }
    const int folder = ::open(QFile::encodeName(m_files).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder >= 0) { // The tiles come to disk before it is said that they are there.
        const bool synced = ::syncfs(folder) == 0;
        const int code = errno;
        ::close(folder);
        if (!synced)
            return Error{FileReplacement::reason(m_files, code)};
    }
    const View &view = m_picture.plan.view();
    const TileOptions &options = m_picture.plan.options();
    const QString format = endingOf(m_picture.encoding.format);
    const QByteArray page =
        deepZoomPage({QFileInfo(m_files).fileName(), format, view.width, view.height, options.tile, options.overlap});
    if (Result<void> written = replaceFile(pageOf(m_picture.path), page, true); !written)
        return written;
    const QByteArray description = QStringLiteral("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                                  "<Image xmlns=\"http://schemas.microsoft.com/deepzoom/2008\" "
                                                  "Format=\"%1\" Overlap=\"%2\" TileSize=\"%3\">\n"
                                                  "  <Size Width=\"%4\" Height=\"%5\"/>\n</Image>\n")
                                       .arg(format)
                                       .arg(options.overlap)
                                       .arg(options.tile)
                                       .arg(view.width)
                                       .arg(view.height)
                                       .toUtf8();
    return replaceFile(m_picture.path, description, true);
}

Result<void> PackFile::open(const QString &path, qint64 from)
{
    m_path = path;
    m_file.setFileName(path);
    if (!m_file.open(QIODevice::ReadWrite | QIODevice::Unbuffered))
        return Error{QCoreApplication::translate("Tiles",
                                                 "%1: cannot be written (%2). Choose another folder, or change "
                                                 "its permissions.")
                         .arg(path, m_file.errorString())};
    m_end = std::max(from, m_file.size());
    return {};
}

Result<qint64> PackFile::add(const QByteArray &bytes)
{
    qint64 at = 0;
    {
        const std::lock_guard lock(m_mutex);
        at = m_end;
        m_end += bytes.size();
    }
    for (qint64 done = 0; done < bytes.size();) {
        const ssize_t n =
            ::pwrite(m_file.handle(), bytes.constData() + done, std::size_t(bytes.size() - done), at + done);
        if (n > 0)
            done += n;
        else if (n == 0 || errno != EINTR)
            return Error{FileReplacement::reason(m_path, n == 0 ? ENOSPC : errno)};
    }
    return at;
}

PackStore::PackStore(PackRecords records, TileJournal &journal, PackFile &file, qint64 base)
    : m_records(std::move(records)), m_journal(journal), m_file(file), m_base(base)
{}

namespace {

/// The tiles of a record, if they are whole.
std::optional<QByteArray> tilesOf(const std::pair<SheetRecord, QString> &place)
{
    QFile file(place.second);
    if (!file.open(QIODevice::ReadOnly) || !file.seek(place.first.offset))
        return {};
    QByteArray tiles = file.read(place.first.size());
    return isWhole(place.first, tiles) ? std::optional(std::move(tiles)) : std::nullopt;
}

} // namespace

bool PackStore::has(qint64 sheet)
{
    const auto [from, to] = m_records.equal_range(sheet);
    return from != to && tilesOf(std::prev(to)->second).has_value();
}

std::optional<std::pair<SheetRecord, QByteArray>> PackStore::whole(qint64 sheet) const
{
    const auto [from, to] = m_records.equal_range(sheet);
    for (auto it = from; it != to; ++it)
        if (auto tiles = tilesOf(it->second))
            return std::pair(it->second.first, std::move(*tiles));
    return {};
}

Result<void> PackStore::put(const TileSheet &, qint64 number, const std::vector<QByteArray> &tiles)
{
    QByteArray bytes;
    for (const QByteArray &tile : tiles)
        bytes += tile;
    const Result<qint64> at = m_file.add(bytes);
    return at ? m_journal.add(sheetRecord(m_base + number, *at, tiles)) : Result<void>(Error{at.error()});
}

} // namespace suffuse
