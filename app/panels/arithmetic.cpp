#include "app/panels/arithmetic.h"

#include <cmath>

namespace suffuse {

namespace {

/// Recursive descent over a sum of products; nesting is bounded so that no input exhausts the stack.
class Parser {
public:
    explicit Parser(const QString &text) : m_text(text) {}

    std::optional<double> whole()
    {
        const std::optional<double> value = sum(0);
        return value && m_at == m_text.size() && std::isfinite(*value) ? value : std::nullopt;
    }

private:
    QChar peek() const { return m_at < m_text.size() ? m_text[m_at] : QChar(); }

    std::optional<double> sum(int depth)
    {
        std::optional<double> left = product(depth);
        while (left && (peek() == '+' || peek() == '-')) {
            const bool minus = m_text[m_at++] == '-';
            const std::optional<double> right = product(depth);
            left = right ? std::optional(minus ? *left - *right : *left + *right) : std::nullopt;
        }
        return left;
    }

    std::optional<double> product(int depth)
    {
        std::optional<double> left = factor(depth);
        while (left && (peek() == '*' || peek() == '/')) {
            const bool divide = m_text[m_at++] == '/';
            const std::optional<double> right = factor(depth);
            left = right ? std::optional(divide ? *left / *right : *left * *right) : std::nullopt;
        }
        return left;
    }

    std::optional<double> factor(int depth)
    {
        if (depth > 32)
            return std::nullopt;
        if (peek() == '-' || peek() == '+') {
            const bool minus = m_text[m_at++] == '-';
            const std::optional<double> value = factor(depth + 1);
            return value && minus ? std::optional(-*value) : value;
        }
        if (peek() == '(') {
            ++m_at;
            const std::optional<double> value = sum(depth + 1);
            if (!value || peek() != ')')
                return std::nullopt;
            ++m_at;
            return value;
        }
        return number();
    }

    std::optional<double> number()
    {
        const qsizetype start = m_at;
        while (peek().isDigit() || peek() == '.')
            ++m_at;
        if (m_at > start && peek().toLower() == 'e') {
            ++m_at;
            if (peek() == '+' || peek() == '-')
                ++m_at;
            while (peek().isDigit())
                ++m_at;
        }
        bool ok = false;
        const double value = m_text.mid(start, m_at - start).toDouble(&ok);
        return ok ? std::optional(value) : std::nullopt;
    }

    QString m_text;
    qsizetype m_at = 0;
};

QString normalised(QString text, const QString &unit)
{
    text = text.trimmed();
    if (!unit.isEmpty() && text.endsWith(unit))
        text.chop(unit.size());
    text.replace(QChar(0x2212), '-').replace(QChar(0x00D7), '*').replace(QChar(0x00F7), '/').replace(',', '.');
    QString compact;
    for (const QChar c : text)
        if (!c.isSpace())
            compact += c;
    return compact;
}

} // namespace

std::optional<double> evaluateArithmetic(const QString &text, std::optional<double> current, const QString &unit)
{
    QString t = normalised(text, unit);
    if (t.isEmpty())
        return std::nullopt;
    const bool assigns = t.size() > 1 && t[1] == '=' && QString("+-*/").contains(t[0]);
    if (assigns)
        t.remove(1, 1);
    const bool relative = assigns || t[0] == '+' || t[0] == '*' || t[0] == '/';
    if (!relative)
        return Parser(t).whole();
    if (!current)
        return std::nullopt;
    return Parser("(" + QString::number(*current, 'g', 17) + ")" + t).whole();
}

} // namespace suffuse
