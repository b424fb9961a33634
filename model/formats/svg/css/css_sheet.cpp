#include "model/formats/svg/css/css_sheet.h"

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

constexpr std::size_t mostSelectors = 20'000;
constexpr int deepestBlocks = 8;
constexpr std::size_t mostCompounds = 16;

/// The first of the characters `stops`, at or after `from`, that stands outside of quotes and brackets; the size of the
/// text if none does.
qsizetype findOutside(QStringView text, qsizetype from, QStringView stops)
{
    QChar quote;
    int brackets = 0;
    for (qsizetype i = from; i < text.size(); ++i) {
        const QChar c = text[i];
        if (c == u'\\') {
            ++i;
        } else if (!quote.isNull()) {
            quote = c == quote ? QChar() : quote;
        } else if (brackets == 0 && stops.contains(c)) {
            return i;
        } else if (c == u'"' || c == u'\'') {
            quote = c;
        } else if (c == u'(' || c == u'[') {
            ++brackets;
        } else if ((c == u')' || c == u']') && brackets > 0) {
            --brackets;
        }
    }
    return text.size();
}

/// The text with spaces for comments, and for the <!-- and --> in which HTML hides sheets.
QString withoutComments(const QString &text)
{
    QString result;
    result.reserve(text.size());
    QChar quote;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QStringView rest = QStringView(text).mid(i);
        if (quote.isNull() && rest.startsWith(u"/*")) {
            const qsizetype end = text.indexOf(QLatin1String("*/"), i + 2);
            i = end < 0 ? text.size() : end + 1;
            result += u' ';
        } else if (quote.isNull() && (rest.startsWith(u"<!--") || rest.startsWith(u"-->"))) {
            i += text[i] == u'<' ? 3 : 2;
            result += u' ';
        } else {
            const QChar c = text[i];
            if (quote.isNull() ? c == u'"' || c == u'\'' : c == quote || c == u'\n')
                quote = quote.isNull() ? c : QChar();
            result += c;
        }
    }
    return result;
}

std::vector<CssDeclaration> declarationsIn(QStringView text)
{
    std::vector<CssDeclaration> declarations;
    for (qsizetype at = 0; at < text.size();) {
        const qsizetype end = findOutside(text, at, u";");
        const QStringView entry = text.mid(at, end - at);
        at = end + 1;
        const qsizetype colon = entry.indexOf(u':');
        if (colon < 0)
            continue;
        CssDeclaration d{entry.left(colon).trimmed().toString().toLower(), entry.mid(colon + 1).trimmed().toString()};
        if (const qsizetype mark = d.value.lastIndexOf(u'!');
            mark >= 0 &&
            QStringView(d.value).mid(mark + 1).trimmed().compare(QLatin1String("important"), Qt::CaseInsensitive) == 0)
            d.value = d.value.left(mark).trimmed(), d.important = true;
        if (!d.property.isEmpty() && !d.value.isEmpty())
            declarations.push_back(std::move(d));
    }
    return declarations;
}

bool isNameCharacter(QChar c)
{
    return c.isLetterOrNumber() || c == u'-' || c == u'_' || c == u'\\' || c.unicode() >= 0x80;
}

/// Takes the name that starts at `at`, which is moved behind it. Escapes (\3a, \:) are replaced by what they mean.
QString takeName(QStringView text, qsizetype &at)
{
    QString name;
    while (at < text.size() && isNameCharacter(text[at])) {
        if (text[at] != u'\\') {
            name += text[at++];
            continue;
        }
        const qsizetype from = ++at;
        while (at < text.size() && at < from + 6 && QStringView(u"0123456789abcdefABCDEF").contains(text[at]))
            ++at;
        if (at > from) {
            const uint code = text.mid(from, at - from).toUInt(nullptr, 16);
            name += QString::fromUcs4(reinterpret_cast<const char32_t *>(&code), code > 0 && code <= 0x10ffff ? 1 : 0);
            at += at < text.size() && text[at].isSpace() ? 1 : 0;
        } else if (at < text.size()) {
            name += text[at++];
        }
    }
    return name;
}

bool isStateOfInteraction(const QString &name)
{
    static const QSet<QString> states{"hover",         "active", "focus", "visited",   "focus-within", "target",
                                      "focus-visible", "before", "after", "selection", "checked",      "disabled"};
    return states.contains(name.toLower());
}

bool isForScreens(QStringView query)
{
    const QString text = query.trimmed().toString().toLower();
    return text.isEmpty() || text == QLatin1String("all") || text == QLatin1String("screen") ||
           text == QLatin1String("all, screen") || text == QLatin1String("screen, print") ||
           text == QLatin1String("only screen");
}

} // namespace

std::vector<CssDeclaration> cssDeclarations(const QString &text)
{
    return text.contains(QLatin1String("/*")) ? declarationsIn(withoutComments(text)) : declarationsIn(text);
}

void CssSheet::add(const QString &text)
{
    addRules(withoutComments(text), 0);
}

void CssSheet::addRules(QStringView text, int depth)
{
    for (qsizetype at = 0; at < text.size();) {
        const qsizetype open = findOutside(text, at, u"{;}");
        const QStringView head = text.mid(at, open - at).trimmed();
        at = open + 1;
        if (open == text.size())
            return;
        if (text[open] != u'{') { // It is @import or @charset, or there is a bracket too many.
            m_unread += head.startsWith(QLatin1String("@import"), Qt::CaseInsensitive) ? 1 : 0;
            continue;
        }
        qsizetype end = open;
        for (int level = 1; level > 0 && end < text.size();) {
            end = findOutside(text, end + 1, u"{}");
            level += end < text.size() && text[end] == u'{' ? 1 : -1;
        }
        const QStringView block = text.mid(open + 1, end - open - 1);
        at = end + 1;
        if (!head.startsWith(u'@'))
            addRule(head, block);
        else if (head.startsWith(QLatin1String("@media"), Qt::CaseInsensitive) && isForScreens(head.mid(6)) &&
                 depth < deepestBlocks)
            addRules(block, depth + 1);
    }
}

void CssSheet::addRule(QStringView selectors, QStringView block)
{
    std::vector<CssDeclaration> declarations = declarationsIn(block);
    if (declarations.empty())
        return;
    m_blocks.push_back(std::move(declarations));
    for (qsizetype at = 0; at <= selectors.size();) {
        const qsizetype end = findOutside(selectors, at, u",");
        Selector selector;
        selector.block = m_blocks.size() - 1;
        const Reading reading = readSelector(selectors.mid(at, end - at).trimmed(), selector);
        at = end + 1;
        const bool isKept = reading == Reading::Done && m_selectors.size() < mostSelectors;
        m_unread += reading != Reading::Never && !isKept ? 1 : 0;
        if (!isKept)
            continue;
        const Compound &last = selector.compounds.back();
        auto &list = !last.id.isEmpty()        ? m_byId[last.id]
                     : !last.classes.isEmpty() ? m_byClass[last.classes.front()]
                     : !last.type.isEmpty()    ? m_byType[last.type]
                                               : m_universal;
        list.push_back(m_selectors.size());
        m_asksForAncestors = m_asksForAncestors || selector.compounds.size() > 1;
        for (const Compound &compound : selector.compounds)
            m_askedIds.insert(compound.id);
        m_selectors.push_back(std::move(selector));
    }
}

CssSheet::Reading CssSheet::readSelector(QStringView text, Selector &selector)
{
    Compound compound;
    bool isStarted = false;
    const auto finish = [&] {
        if (isStarted)
            selector.compounds.push_back(std::exchange(compound, Compound()));
        return std::exchange(isStarted, false);
    };
    for (qsizetype at = 0; at < text.size();) {
        const QChar c = text[at];
        if (c.isSpace() || c == u'>') {
            finish();
            if (c == u'>' && (selector.compounds.empty() || compound.isChild))
                return Reading::NotUnderstood;
            compound.isChild = compound.isChild || c == u'>';
            ++at;
            continue;
        }
        const bool isNamed = c == u'.' || c == u'#' || c == u':';
        at += isNamed || c == u'*' ? 1 : 0;
        const QString name = c == u'*' ? QString() : takeName(text, at);
        if (c == u':' && (isStateOfInteraction(name) || text.mid(at).startsWith(u':')))
            return Reading::Never;
        if (c == u':' || (c != u'*' && name.isEmpty()) || (!isNamed && isStarted))
            return Reading::NotUnderstood; // Attributes, siblings and counting are not understood.
        if (c == u'#')
            compound.id = name;
        else if (c == u'.')
            compound.classes << name;
        else
            compound.type = name;
        selector.specificity += c == u'#' ? 1'000'000 : c == u'.' ? 1'000 : c == u'*' ? 0 : 1;
        isStarted = true;
    }
    const bool isWhole = finish() && selector.compounds.size() <= mostCompounds;
    return isWhole ? Reading::Done : Reading::NotUnderstood;
}

bool CssSheet::isMatch(const Compound &compound, const CssElement &element)
{
    ++m_steps;
    return (compound.type.isEmpty() || compound.type == element.name) &&
           (compound.id.isEmpty() || compound.id == element.id) &&
           std::ranges::all_of(compound.classes,
                               [&element](const QString &name) { return element.classes.contains(name); });
}

/// Matches from right to left. `reachable` is the set of parts that the path of ancestors so far can have matched, so
/// no choice has to be taken back.
bool CssSheet::isMatch(const Selector &selector, const CssElement &element)
{
    const std::vector<Compound> &parts = selector.compounds;
    if (!isMatch(parts.back(), element))
        return false;
    const std::size_t count = parts.size();
    quint32 floating = 0; ///< bit k: part k may be any ancestor from here on
    quint32 next = 0;     ///< bit k: part k must be the next ancestor
    const auto expect = [&](std::size_t matched) { (parts[matched].isChild ? next : floating) |= 1u << (matched - 1); };
    if (count == 1)
        return true;
    expect(count - 1);
    for (const CssElement *above = element.parent; above && (floating | next) && m_steps <= mostSteps;
         above = above->parent) {
        const quint32 asked = floating | std::exchange(next, 0);
        for (std::size_t k = 0; k + 1 < count; ++k) {
            if (!(asked >> k & 1) || !isMatch(parts[k], *above))
                continue;
            if (k == 0)
                return true;
            expect(k);
        }
    }
    return false;
}

void CssSheet::collect(const CssElement &element, const std::vector<std::size_t> &candidates,
                       std::vector<std::size_t> &matches)
{
    for (const std::size_t candidate : candidates)
        if (m_steps <= mostSteps && isMatch(m_selectors[candidate], element))
            matches.push_back(candidate);
}

/// Sorts elements by what selectors can tell apart. Ids that no selector names do not count, and ancestors count only
/// if a selector asks for them.
int CssSheet::kindOf(const CssElement &element)
{
    QString key = element.name + u'\n' + element.classes.join(u' ') + u'\n';
    if (m_askedIds.contains(element.id))
        key += element.id;
    if (m_asksForAncestors && element.parent) {
        auto above = m_kindOfParent.constFind(element.parent);
        if (above == m_kindOfParent.constEnd())
            above = m_kindOfParent.insert(element.parent, kindOf(*element.parent));
        key += u'\n' + QString::number(*above);
    }
    const auto known = m_kinds.constFind(key);
    return known != m_kinds.constEnd() ? *known : *m_kinds.insert(key, int(m_kinds.size()));
}

CssSheet::Declarations CssSheet::find(const CssElement &element)
{
    std::vector<std::size_t> matches;
    collect(element, m_universal, matches);
    collect(element, m_byType.value(element.name), matches);
    for (const QString &name : element.classes)
        collect(element, m_byClass.value(name), matches);
    collect(element, m_byId.value(element.id), matches);
    std::ranges::sort(matches, {}, [this](std::size_t i) { return std::pair(m_selectors[i].specificity, i); });
    Declarations found;
    for (const std::size_t match : matches)
        for (const CssDeclaration &d : m_blocks[m_selectors[match].block])
            found.push_back(&d);
    m_steps += 10 * qint64(found.size());
    return found;
}

const CssSheet::Declarations &CssSheet::matching(const CssElement &element)
{
    static const Declarations none;
    if (m_selectors.empty() || m_steps > mostSteps)
        return none;
    const int kind = kindOf(element);
    auto known = m_found.constFind(kind);
    if (known == m_found.constEnd())
        known = m_found.insert(kind, find(element));
    return *known;
}

} // namespace suffuse
