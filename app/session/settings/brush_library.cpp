#include "app/session/settings/brush_library.h"

#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "model/formats/files.h"

#include <QCoreApplication>
#include <QDir>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QUuid>

namespace suffuse {

namespace {

constexpr int mostOwn = 2000;   ///< at most so many files are read
constexpr int longestName = 80; ///< characters
const char *const favouritesKey = "brushes/favourites";

QStringList usualFavourites()
{
    return {"ink-wash", "brush-pen", "flat-wash",   "watercolour-edge", "wet-in-wet",
            "pencil",   "dry-chalk", "flat-marker", "soft-airbrush"};
}

/// Alters the favourites of all running instances. Some may be brushes that this instance does not know yet.
void updateFavourites(const std::function<void(QStringList &names)> &change)
{
    settings::updateList(
        favouritesKey,
        [&](QStringList names) {
            change(names);
            return names;
        },
        usualFavourites());
}

QString cleaned(const QString &name)
{
    return name.simplified().left(longestName);
}

/// A file name for a brush. It has only characters that every file system takes.
QString fileNameOf(const QString &name)
{
    static const QRegularExpression other(QStringLiteral("[^\\w .()+-]"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    QString file = name;
    file.replace(other, QStringLiteral("_"));
    while (file.startsWith('.'))
        file.remove(0, 1);
    return file.isEmpty() ? QUuid::createUuid().toString(QUuid::Id128) : file.left(60);
}

} // namespace

BrushLibrary &BrushLibrary::instance()
{
    static BrushLibrary library(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                                QStringLiteral("/brushes"));
    return library;
}

BrushLibrary::BrushLibrary(const QString &folder, QObject *parent)
    : QObject(parent), m_folder(folder), m_brushes(builtinBrushes())
{
    readFolder();
}

void BrushLibrary::readFolder()
{
    const QStringList filter{QStringLiteral("*.") + QLatin1String(brushFileEnding)};
    const QFileInfoList files = QDir(m_folder).entryInfoList(filter, QDir::Files, QDir::Name);
    for (const QFileInfo &file : files.mid(0, mostOwn)) {
        Result<LoadedBrush> loaded = loadBrush(file.filePath());
        if (!loaded || find(loaded->brush.name))
            continue;
        m_files.insert(loaded->brush.name, file.filePath());
        m_brushes.push_back(std::move(loaded->brush));
    }
    sort();
}

void BrushLibrary::sort()
{
    const auto own = m_brushes.begin() + std::ptrdiff_t(builtinBrushes().size());
    std::sort(own, m_brushes.end(),
              [](const Brush &a, const Brush &b) { return a.name.localeAwareCompare(b.name) < 0; });
}

const Brush *BrushLibrary::find(const QString &name) const
{
    const auto it = std::find_if(m_brushes.begin(), m_brushes.end(), [&](const Brush &b) { return b.name == name; });
    return it == m_brushes.end() ? nullptr : &*it;
}

bool BrushLibrary::isChanged(const Brush &brush) const
{
    const Brush *preset = find(brush.name);
    return preset && !isSameBrush(brush, *preset);
}

QString BrushLibrary::freeName(const QString &wanted) const
{
    const QString base = wanted.isEmpty() ? tr("Brush") : wanted;
    QString name = base;
    for (int n = 2; find(name); ++n)
        name = tr("%1 %2").arg(base).arg(n);
    return name;
}

Result<QString> BrushLibrary::add(Brush brush)
{
    brush.name = freeName(cleaned(brush.name));
    if (!QDir().mkpath(m_folder))
        return Error{
            tr("%1: the folder could not be made; check its permissions").arg(QDir::toNativeSeparators(m_folder))};
    QString path;
    for (int n = 1; path.isEmpty() || QFileInfo::exists(path); ++n)
        path = QStringLiteral("%1/%2%3.%4")
                   .arg(m_folder, fileNameOf(brush.name), n > 1 ? QString::number(n) : QString(),
                        QLatin1String(brushFileEnding));
    if (Result<void> written = writeFileAtomically(path, writeBrush(brush)); !written)
        return Error{written.error()};
    m_files.insert(brush.name, path);
    const QString name = brush.name;
    m_brushes.push_back(std::move(brush));
    sort();
    emit changed();
    return name;
}

Result<void> BrushLibrary::save(const Brush &brush)
{
    if (!isOwn(brush.name))
        return Error{tr("%1 is a built-in brush; save it under a name of its own").arg(brushTitle(brush.name))};
    if (Result<void> written = writeFileAtomically(m_files.value(brush.name), writeBrush(brush)); !written)
        return written;
    std::replace_if(
        m_brushes.begin(), m_brushes.end(), [&](const Brush &b) { return b.name == brush.name; }, brush);
    m_left.remove(brush.name);
    emit changed();
    return {};
}

Result<void> BrushLibrary::rename(const QString &name, const QString &to)
{
    const QString wanted = cleaned(to);
    if (!isOwn(name) || wanted == name)
        return {};
    if (wanted.isEmpty() || find(wanted))
        return Error{wanted.isEmpty() ? tr("A brush needs a name") : tr("There is a brush “%1” already").arg(wanted)};
    Brush brush = *find(name);
    brush.name = wanted;
    const QString path = m_files.value(name);
    if (Result<void> written = writeFileAtomically(path, writeBrush(brush)); !written)
        return written;
    erase(name);
    m_files.insert(wanted, path);
    m_brushes.push_back(std::move(brush));
    sort();
    updateFavourites([&](QStringList &names) { std::replace(names.begin(), names.end(), name, wanted); });
    emit changed();
    return {};
}

void BrushLibrary::erase(const QString &name)
{
    m_files.remove(name);
    m_left.remove(name);
    std::erase_if(m_brushes, [&](const Brush &b) { return b.name == name; });
}

Result<void> BrushLibrary::remove(const QString &name)
{
    if (!isOwn(name))
        return Error{tr("%1 is a built-in brush; it stays").arg(brushTitle(name))};
    const QString path = m_files.value(name);
    if (QFileInfo::exists(path) && !QFile::remove(path))
        return Error{tr("%1 could not be removed; check its permissions").arg(QDir::toNativeSeparators(path))};
    erase(name);
    emit changed();
    return {};
}

Result<QString> BrushLibrary::import(const QString &path, QStringList *left)
{
    Result<LoadedBrush> loaded = loadBrush(path);
    if (!loaded)
        return Error{loaded.error()};
    if (left)
        *left = loaded->left;
    return add(std::move(loaded->brush));
}

Result<void> BrushLibrary::exportTo(const QString &name, const QString &path) const
{
    const Brush *brush = find(name);
    if (!brush)
        return Error{tr("There is no brush “%1”").arg(name)};
    Brush copy = *brush;
    copy.name = brushTitle(name);
    return writeFileAtomically(path, writeBrush(copy));
}

QStringList BrushLibrary::favourites() const
{
    QStringList names;
    for (const QString &name : settings::store().value(favouritesKey, usualFavourites()).toStringList())
        if (find(name) && !names.contains(name))
            names << name;
    return names;
}

void BrushLibrary::setFavourite(const QString &name, bool favourite)
{
    updateFavourites([&](QStringList &names) {
        names.removeAll(name);
        if (favourite)
            names << name;
    });
    emit changed();
}

void BrushLibrary::use(Editor &editor, const QString &name)
{
    const Brush *preset = find(name);
    const Brush inHand = editor.brush();
    if (!preset || inHand.name == name)
        return;
    if (isChanged(inHand)) {
        m_left.insert(inHand.name, inHand);
        emit changesKept(inHand.name);
    }
    take(editor, m_left.value(name, *preset));
    m_left.remove(name); // The changes are in hand now.
}

void BrushLibrary::reload(Editor &editor, const QString &name)
{
    if (const Brush *preset = find(name)) {
        forgetChanges(name);
        take(editor, *preset);
    }
}

void BrushLibrary::take(Editor &editor, Brush brush)
{
    const Colour &current = editor.brush().colour;
    brush.colour = {current.red, current.yellow, current.blue, brush.colour.opacity};
    editor.setBrush(brush);
}

void BrushLibrary::forgetChanges(const QString &name)
{
    if (m_left.remove(name) > 0)
        emit changesKept(name);
}

bool isSameBrush(const Brush &a, const Brush &b)
{
    Brush other = a;
    other.colour = {b.colour.red, b.colour.yellow, b.colour.blue, a.colour.opacity};
    return other == b;
}

QString brushTitle(const QString &name)
{
    static const std::vector<std::pair<const char *, const char *>> titles{
        {"ink-wash", QT_TRANSLATE_NOOP("Brushes", "Ink wash")},
        {"brush-pen", QT_TRANSLATE_NOOP("Brushes", "Brush pen")},
        {"dry-brush", QT_TRANSLATE_NOOP("Brushes", "Dry brush")},
        {"ink-splash", QT_TRANSLATE_NOOP("Brushes", "Ink splash")},
        {"broad-nib", QT_TRANSLATE_NOOP("Brushes", "Broad nib")},
        {"round-wash", QT_TRANSLATE_NOOP("Brushes", "Round wash")},
        {"flat-wash", QT_TRANSLATE_NOOP("Brushes", "Flat wash")},
        {"watercolour-edge", QT_TRANSLATE_NOOP("Brushes", "Watercolour edge")},
        {"granulating-wash", QT_TRANSLATE_NOOP("Brushes", "Granulating wash")},
        {"wet-in-wet", QT_TRANSLATE_NOOP("Brushes", "Wet in wet")},
        {"glaze", QT_TRANSLATE_NOOP("Brushes", "Glaze")},
        {"two-tone", QT_TRANSLATE_NOOP("Brushes", "Two tones")},
        {"pencil", QT_TRANSLATE_NOOP("Brushes", "Pencil")},
        {"dry-chalk", QT_TRANSLATE_NOOP("Brushes", "Dry chalk")},
        {"charcoal", QT_TRANSLATE_NOOP("Brushes", "Charcoal")},
        {"pastel", QT_TRANSLATE_NOOP("Brushes", "Pastel")},
        {"flat-marker", QT_TRANSLATE_NOOP("Brushes", "Flat marker")},
        {"gouache", QT_TRANSLATE_NOOP("Brushes", "Gouache")},
        {"soft-airbrush", QT_TRANSLATE_NOOP("Brushes", "Soft airbrush")},
        {"glow", QT_TRANSLATE_NOOP("Brushes", "Glow")},
    };
    for (const auto &[id, title] : titles)
        if (name == QLatin1String(id))
            return QCoreApplication::translate("Brushes", title);
    return name;
}

QString brushGroupTitle(const QString &group)
{
    static const std::vector<std::pair<const char *, const char *>> titles{
        {"ink", QT_TRANSLATE_NOOP("Brushes", "Ink")}, {"watercolour", QT_TRANSLATE_NOOP("Brushes", "Watercolour")},
        {"dry", QT_TRANSLATE_NOOP("Brushes", "Dry")}, {"flat", QT_TRANSLATE_NOOP("Brushes", "Flat")},
        {"air", QT_TRANSLATE_NOOP("Brushes", "Air")},
    };
    for (const auto &[id, title] : titles)
        if (group == QLatin1String(id))
            return QCoreApplication::translate("Brushes", title);
    return group.isEmpty() ? QCoreApplication::translate("Brushes", "Others") : group;
}

bool isBrushCalled(const Brush &brush, const QString &typed)
{
    const QString text = typed.trimmed();
    const QString names[] = {brushTitle(brush.name), brushGroupTitle(brush.group), brush.name, brush.group};
    return std::ranges::any_of(names, [&](const QString &name) { return name.contains(text, Qt::CaseInsensitive); });
}

int searchRank(const Brush &brush, const QString &typed)
{
    const QString text = typed.trimmed();
    const auto rankOf = [&text](const QString &name) {
        if (name.compare(text, Qt::CaseInsensitive) == 0)
            return 0;
        if (name.startsWith(text, Qt::CaseInsensitive))
            return 1;
        const bool beginsWord = name.contains(QLatin1Char(' ') + text, Qt::CaseInsensitive) ||
                                name.contains(QLatin1Char('-') + text, Qt::CaseInsensitive);
        return beginsWord ? 2 : name.contains(text, Qt::CaseInsensitive) ? 3 : 4; // 4: its group is called so
    };
    return std::min(rankOf(brushTitle(brush.name)), rankOf(brush.name));
}

} // namespace suffuse
