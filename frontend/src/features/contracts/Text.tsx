import type { Block, Span } from './api'
import classes from './Contracts.module.css'

/** The text of a contract, as the PDF has it. */
export function Text({ blocks }: { blocks: readonly Block[] }) {
  return (
    <div className={classes.text}>
      {grouped(blocks).map((group, index) =>
        Array.isArray(group) ? (
          <ul key={index}>
            {group.map((item, place) => (
              <li key={place}>
                <Spans spans={item.spans} />
              </li>
            ))}
          </ul>
        ) : (
          <One key={index} block={group} />
        ),
      )}
    </div>
  )
}

/** Items that follow one another are one list. */
function grouped(blocks: readonly Block[]): (Block | Block[])[] {
  const groups: (Block | Block[])[] = []
  for (const block of blocks) {
    const last = groups.at(-1)
    if (block.kind !== 'item') groups.push(block)
    else if (Array.isArray(last)) last.push(block)
    else groups.push([block])
  }
  return groups
}

/** The column heads of a table, by which one table is distinguished from the next. */
function wordsOf(head: readonly Span[][]): string {
  return head.map((cell) => cell.map(({ text }) => text).join('')).join(', ')
}

function One({ block }: { block: Block }) {
  if (block.kind === 'head') {
    const Head = block.level === 1 ? 'h2' : 'h3'
    return (
      <Head>
        <Spans spans={block.spans} />
      </Head>
    )
  }
  if (block.kind === 'table') {
    const [head = [], ...rows] = block.rows
    return (
      // A table wider than a telephone is moved by itself, by keys too.
      // eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex
      <div className={classes.table} tabIndex={0} role="region" aria-label={`Table: ${wordsOf(head)}`}>
        <table>
          <thead>
            <tr>
              {head.map((cell, place) => (
                <th key={place} scope="col">
                  <Spans spans={cell} />
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row, place) => (
              <tr key={place}>
                {row.map((cell, column) => (
                  <td key={column}>
                    <Spans spans={cell} />
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    )
  }
  return (
    <p>
      <Spans spans={block.spans} />
    </p>
  )
}

function Spans({ spans }: { spans: readonly Span[] }) {
  return spans.map(({ text, strong, emphatic }, index) =>
    strong ? <strong key={index}>{text}</strong> : emphatic ? <em key={index}>{text}</em> : text,
  )
}
