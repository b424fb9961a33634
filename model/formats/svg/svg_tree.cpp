#include "model/formats/svg/svg_tree.h"

#include <QRegularExpression>

#include <algorithm>

namespace suffuse {

namespace {

constexpr std::size_t deepestElement = 256;
constexpr std::size_t mostElements = 500'000;
constexpr qsizetype longestName = 200;

/// Illustrator writes characters that an id must not have as "_x20_".
QString withoutEscapes(const QString &id)
{
    static const QRegularExpression escape(QStringLiteral("_x([0-9A-Fa-f]{2,4})_"));
    if (!id.contains(QLatin1String("_x")))
        return id;
    QString name;
    qsizetype at = 0;
    for (auto it = escape.globalMatch(id); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        name += id.mid(at, match.capturedStart() - at);
        name += QChar(char16_t(match.captured(1).toUInt(nullptr, 16)));
        at = match.capturedEnd();
    }
    return name + id.mid(at);
}

/// Tarjan's strongly connected components, without recursion. Each element gets the number of its component.
class Components {
public:
    /// `next(i, k)` returns the k-th element to which i leads, and −1 after the last.
    template <class Next>
    Components(int count, const Next &next) : m_order(std::size_t(count), -1), m_low(m_order), m_component(m_order)
    {
        struct Step {
            int at;
            int k = 0;
        };
        std::vector<Step> path;
        for (int start = 0; start < count; ++start) {
            if (m_order[std::size_t(start)] < 0)
                path.push_back({enter(start)});
            while (!path.empty()) {
                const int at = path.back().at, to = next(at, path.back().k++);
                if (to < 0) {
                    leave(at);
                    path.pop_back();
                    if (!path.empty())
                        lower(path.back().at, m_low[std::size_t(at)]);
                } else if (m_order[std::size_t(to)] < 0) {
                    path.push_back({enter(to)});
                } else if (m_component[std::size_t(to)] < 0) {
                    lower(at, m_order[std::size_t(to)]);
                }
            }
        }
    }
    int operator[](int i) const { return m_component[std::size_t(i)]; }

private:
    int enter(int i)
    {
        m_order[std::size_t(i)] = m_low[std::size_t(i)] = m_entered++;
        m_open.push_back(i);
        return i;
    }
    void lower(int i, int to) { m_low[std::size_t(i)] = std::min(m_low[std::size_t(i)], to); }
    void leave(int i)
    {
        if (m_low[std::size_t(i)] != m_order[std::size_t(i)])
            return;
        for (int top = -1; top != i; m_open.pop_back())
            m_component[std::size_t(top = m_open.back())] = m_components;
        ++m_components;
    }

    std::vector<int> m_order, m_low, m_component, m_open;
    int m_entered = 0, m_components = 0;
};

} // namespace

QString SvgElement::givenName() const
{
    const QString label =
        attributes.value(QLatin1String("http://www.inkscape.org/namespaces/inkscape"), QLatin1String("label"))
            .toString();
    for (const QString &given : {label, title, attribute("data-name"), withoutEscapes(id)})
        if (const QString name = given.simplified(); !name.isEmpty())
            return name.left(longestName);
    return {};
}

QString SvgTree::read(QXmlStreamReader &xml)
{
    std::vector<SvgElement *> open{&m_root};
    std::size_t textDepth = 0; ///< of the outermost <text> that is open
    QString sheet;
    while (!xml.atEnd()) {
        const auto token = xml.readNext();
        SvgElement &inner = *open.back();
        const bool isSheet = inner.name == QLatin1String("style");
        if (token == QXmlStreamReader::EndElement) {
            if (const QString type = inner.attribute("type");
                isSheet && (type.isEmpty() || type == QLatin1String("text/css")))
                m_sheet.add(sheet);
            sheet.clear();
            open.pop_back();
            textDepth = textDepth < open.size() ? textDepth : 0;
        } else if (token == QXmlStreamReader::Characters && isSheet) {
            sheet += xml.text();
        } else if (token == QXmlStreamReader::Characters && inner.name == QLatin1String("title") && open.size() > 2) {
            QString &title = open[open.size() - 2]->title;
            title += xml.text().left(std::max<qsizetype>(0, 2 * longestName - title.size()));
        } else if (token == QXmlStreamReader::Characters && textDepth > 0) {
            takeCharacters(xml.text(), inner);
        } else if (token == QXmlStreamReader::StartElement) {
            if (open.size() > deepestElement || m_elements.size() >= mostElements) {
                m_isCut = true;
                xml.skipCurrentElement();
                continue;
            }
            take(xml, inner);
            if (textDepth == 0 && inner.children.back()->name == QLatin1String("text"))
                textDepth = open.size();
            open.push_back(inner.children.back().get());
        }
    }
    if (xml.hasError())
        return xml.errorString();
    markCycles();
    return {};
}

void SvgTree::take(QXmlStreamReader &xml, SvgElement &parent)
{
    auto element = std::make_unique<SvgElement>();
    element->name = xml.name().toString();
    element->attributes = xml.attributes();
    element->id = element->attribute("id");
    element->classes = element->attribute("class").simplified().split(u' ', Qt::SkipEmptyParts);
    element->parent = &parent == &m_root ? nullptr : &parent;
    element->index = int(m_elements.size());
    if (!element->id.isEmpty() && !m_named.contains(element->id))
        m_named.insert(element->id, element.get());
    m_elements.push_back(element.get());
    parent.children.push_back(std::move(element));
}

void SvgTree::takeCharacters(QStringView characters, SvgElement &parent)
{
    if (parent.children.empty() || parent.children.back()->name != SvgElement::characterData) {
        if (m_elements.size() >= mostElements) {
            m_isCut = true;
            return;
        }
        auto element = std::make_unique<SvgElement>();
        element->name = SvgElement::characterData;
        element->parent = &parent;
        element->index = int(m_elements.size());
        m_elements.push_back(element.get());
        parent.children.push_back(std::move(element));
    }
    parent.children.back()->characters += characters;
}

const SvgElement *SvgTree::find(QStringView reference) const
{
    return reference.startsWith(u'#') ? m_named.value(reference.mid(1).toString()) : nullptr;
}

const SvgElement *SvgTree::target(const SvgElement &element) const
{
    const QString href = element.attribute("href");
    return find(href.isEmpty()
                    ? element.attributes.value(QLatin1String("http://www.w3.org/1999/xlink"), QLatin1String("href"))
                    : QStringView(href));
}

/// An element leads to its children, and a <use> to its target. An element that leads back to itself would never end,
/// and the <use> on the way back is the reason.
void SvgTree::markCycles()
{
    std::vector<int> targets(m_elements.size(), -1);
    bool any = false;
    for (const SvgElement *element : m_elements)
        if (element->name == QLatin1String("use"))
            if (const SvgElement *to = target(*element))
                targets[std::size_t(element->index)] = to->index, any = true;
    if (!any)
        return;
    const Components component(int(m_elements.size()), [&](int i, int k) {
        const auto &children = m_elements[std::size_t(i)]->children;
        if (k < int(children.size()))
            return children[std::size_t(k)]->index;
        return k == int(children.size()) ? targets[std::size_t(i)] : -1;
    });
    for (SvgElement *element : m_elements)
        if (const int to = targets[std::size_t(element->index)]; to >= 0)
            element->isCycle = component[element->index] == component[to];
}

} // namespace suffuse
