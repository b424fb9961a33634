// The manual as it is compiled into the program: pages of Markdown in each language (docs/manual).
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace suffuse {

struct ManualPage {
    QString name;    ///< of its file, without ".md"; the same in every language
    QString title;   ///< its heading
    QString section; ///< the heading below which the contents list it; empty for the contents themselves
    QString text;    ///< Markdown
};

/// A page in which something was found.
struct ManualHit {
    std::size_t page = 0; ///< index of the page
    QString excerpt;      ///< what stands around the first word found
};

/// All pages in one language, in the order in which the contents (index.md, the first page) list them.
class ManualPages {
public:
    /// `code` is one of `translationCodes()`; for any other it is the English manual.
    explicit ManualPages(const QString &code);

    const std::vector<ManualPage> &all() const { return m_pages; }
    /// The page of that name, or the contents where there is none.
    std::size_t indexOf(const QString &name) const;
    /// The pages that hold every word of `words`, the best first: those with the words in their title, then in a
    /// heading, then those that have them most often. Upper and lower case are the same. No words: no page.
    std::vector<ManualHit> search(const QString &words) const;

    /// The words that are looked for: parted at blanks.
    static QStringList wordsOf(const QString &words);
    /// What a reader sees of a Markdown text.
    static QString plainText(const QString &markdown);

private:
    std::vector<ManualPage> m_pages;
    std::vector<QString> m_plain; ///< of each page
};

} // namespace suffuse
