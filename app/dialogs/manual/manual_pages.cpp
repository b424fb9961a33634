#include "app/dialogs/manual/manual_pages.h"

#include <QFile>
#include <QRegularExpression>

#include <algorithm>

namespace suffuse {

namespace {

/// Without a file: an empty text.
QString pageText(const QString &code, const QString &name)
{
    QFile file(QStringLiteral(":/manual/%1/%2.md").arg(code, name));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The first heading.
QString pageTitle(const QString &text)
{
    const QString first = text.section('\n', 0, 0);
    return first.startsWith(QLatin1String("# ")) ? first.mid(2).trimmed() : QString();
}

/// How well a page answers: a title counts more than headings, these more than a word in the text. Less than 0: a word
/// is missing.
int pageWorth(const ManualPage &page, const QString &plain, const QStringList &words)
{
    constexpr int inTitle = 1000, inHeading = 50, most = 40;
    int worth = 0;
    for (const QString &word : words) {
        const auto count = int(plain.count(word, Qt::CaseInsensitive));
        if (count == 0)
            return -1;
        worth += std::min(count, most) + (page.title.contains(word, Qt::CaseInsensitive) ? inTitle : 0);
        for (const QString &line : page.text.split('\n'))
            if (line.startsWith(QLatin1String("##")) && line.contains(word, Qt::CaseInsensitive))
                worth += inHeading;
    }
    return worth;
}

/// What stands around the first of the words, from the start of a word on.
QString excerptOf(const QString &plain, const QStringList &words)
{
    constexpr int before = 30, length = 120;
    qsizetype at = plain.size();
    const qsizetype title = plain.indexOf('\n'); // which the row has anyway
    for (const QString &word : words)
        if (const qsizetype found = plain.indexOf(word, std::max<qsizetype>(title, 0), Qt::CaseInsensitive); found >= 0)
            at = std::min(at, found);
    if (at == plain.size())
        at = std::max<qsizetype>(title + 1, 0);
    qsizetype from = std::max<qsizetype>(at - before, title + 1);
    while (from > 0 && from < at && !plain[from - 1].isSpace() && plain[from].script() != QChar::Script_Han)
        ++from;
    const QString part = plain.mid(from, length).simplified();
    return (from > title + 1 ? QStringLiteral("… ") : QString()) + part;
}

} // namespace

ManualPages::ManualPages(const QString &code)
{
    QString language = code, contents = pageText(code, "index");
    if (contents.isEmpty()) {
        language = "en";
        contents = pageText(language, "index");
    }
    m_pages.push_back({"index", pageTitle(contents), {}, contents});
    static const QRegularExpression link("\\]\\(([a-z-]+)\\.md\\)");
    QString section;
    for (const QString &line : contents.split('\n')) {
        if (line.startsWith(QLatin1String("## ")))
            section = line.mid(3).trimmed();
        const QRegularExpressionMatch match = link.match(line);
        if (!match.hasMatch() || indexOf(match.captured(1)) != 0)
            continue;
        const QString text = pageText(language, match.captured(1));
        m_pages.push_back({match.captured(1), pageTitle(text), section, text});
    }
    for (const ManualPage &page : m_pages)
        m_plain.push_back(plainText(page.text));
}

std::size_t ManualPages::indexOf(const QString &name) const
{
    const auto at = std::ranges::find(m_pages, name, &ManualPage::name);
    return at == m_pages.end() ? 0 : std::size_t(at - m_pages.begin());
}

QStringList ManualPages::wordsOf(const QString &words)
{
    return words.simplified().split(' ', Qt::SkipEmptyParts);
}

QString ManualPages::plainText(const QString &markdown)
{
    static const QRegularExpression picture("!\\[[^\\]]*\\]\\([^)]*\\)\\n*"), link("\\[([^\\]]*)\\]\\([^)]*\\)"),
        marks("^(#+|[-*]|\\d+\\.) +|^\\|?[-:| ]{3,}\\|?$|\\*\\*|`|^```.*$",
              QRegularExpression::MultilineOption),
        cells(" *\\| *");
    QString text = markdown;
    text.remove(picture).replace(link, "\\1").remove(marks).replace(cells, "  ");
    return text;
}

std::vector<ManualHit> ManualPages::search(const QString &words) const
{
    const QStringList wanted = wordsOf(words);
    std::vector<std::pair<int, std::size_t>> found;
    for (std::size_t i = 1; i < m_pages.size() && !wanted.isEmpty(); ++i) // the contents repeat titles only
        if (const int worth = pageWorth(m_pages[i], m_plain[i], wanted); worth >= 0)
            found.emplace_back(-worth, i);
    std::ranges::sort(found);
    std::vector<ManualHit> hits;
    for (const auto &[worth, page] : found)
        hits.push_back({page, excerptOf(m_plain[page], wanted)});
    return hits;
}

} // namespace suffuse
