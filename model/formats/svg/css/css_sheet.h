// Style sheets as far as drawings need them: which declarations apply to which elements of a tree.
#pragma once

#include <QHash>
#include <QSet>
#include <QString>
#include <QStringList>

#include <vector>

namespace suffuse {

/// A declaration such as "fill: red !important", with its property in lower case.
struct CssDeclaration {
    QString property;
    QString value;
    bool important = false;
};

/// The declarations of a block or of a style attribute, in their order. Comments, and what is no declaration, are left
/// out.
std::vector<CssDeclaration> cssDeclarations(const QString &text);

/// What selectors ask about an element.
struct CssElement {
    QString name; ///< without its namespace
    QString id;
    QStringList classes;
    const CssElement *parent = nullptr;
};

/// The rules of a document's style sheets. Selectors are made of types, *, classes and ids, of one element, of
/// descendants ("g .a") and of children ("g > .a"). The cost is bounded for any text: at most 20,000 selectors are
/// kept, and matching ends after about 3·10⁷ steps, as if there were no more rules.
class CssSheet {
public:
    using Declarations = std::vector<const CssDeclaration *>;

    /// Adds the text of a <style> behind what was added before.
    void add(const QString &text);

    /// The declarations that apply to an element, the weakest first (by specificity, then by order). Those with
    /// !important stand among the others. The element's ancestors must stay where they are. The result is valid until
    /// the next call.
    const Declarations &matching(const CssElement &element);

    /// The number of selectors that were not understood, so that their rules were left out. States such as :hover,
    /// which a drawing never has, do not count.
    int unread() const { return m_unread + (m_steps > mostSteps ? int(m_selectors.size()) : 0); }

private:
    static constexpr qint64 mostSteps = 30'000'000;

    /// The part of a selector that is about one element.
    struct Compound {
        QString type; ///< empty: any type
        QString id;
        QStringList classes;
        /// whether it must be a child of what the part to its left describes; else it may be any descendant
        bool isChild = false;
    };
    struct Selector {
        std::vector<Compound> compounds; ///< the last one describes the element itself
        int specificity = 0;
        std::size_t block = 0; ///< the index of its block in m_blocks
    };

    void addRules(QStringView text, int depth);
    void addRule(QStringView selectors, QStringView block);
    enum class Reading { Done, Never, NotUnderstood };
    static Reading readSelector(QStringView text, Selector &selector);
    bool isMatch(const Selector &selector, const CssElement &element);
    bool isMatch(const Compound &compound, const CssElement &element);
    void collect(const CssElement &element, const std::vector<std::size_t> &candidates,
                 std::vector<std::size_t> &matches);
    Declarations find(const CssElement &element);
    int kindOf(const CssElement &element);

    std::vector<std::vector<CssDeclaration>> m_blocks;
    std::vector<Selector> m_selectors;
    /// The selectors by the rarest thing for which their last part asks.
    QHash<QString, std::vector<std::size_t>> m_byId, m_byClass, m_byType;
    std::vector<std::size_t> m_universal;
    QSet<QString> m_askedIds;
    bool m_asksForAncestors = false;
    /// The elements of one kind look the same to every selector, and share what was found.
    QHash<QString, int> m_kinds;
    QHash<const CssElement *, int> m_kindOfParent;
    QHash<int, Declarations> m_found;
    int m_unread = 0;
    qint64 m_steps = 0;
};

} // namespace suffuse
