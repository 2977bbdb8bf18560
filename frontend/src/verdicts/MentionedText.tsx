import type { Mention } from './mentionNames'

/** A text in which the names of those whom it mentions stand out. */
export function MentionedText({ text, mentions }: { text: string; mentions: readonly Mention[] }) {
  const names = mentions.map(({ name }) => `@${name}`).sort((a, b) => b.length - a.length)
  if (names.length === 0) return text
  const escaped = names.map((name) => name.replaceAll(/[.*+?^${}()|[\]\\]/g, String.raw`\$&`))
  return text.split(new RegExp(`(${escaped.join('|')})`, 'u')).map((part, index) =>
    names.includes(part) ? (
      <span key={index} className="strong">
        {part}
      </span>
    ) : (
      part
    ),
  )
}
