import { check, type CueLength, type Finding, type SpecView, whole } from './checks'
import { peaksOf } from './peaks'
import { LeftToServer, type Read, readLayout, Unreadable } from './wav'

/** A file to judge, and what by. */
export interface Judgeable {
  file: Blob
  spec: SpecView
  length: CueLength | null
}

export interface Judgement {
  /** The server could not read the file: it would say nothing else of it. */
  isUnreadable: boolean
  findings: Finding[]
}

/** Whether a file is a FLAC by its bytes and its name; one without a name is known by its bytes. */
async function startsAsFlac(file: Blob, read: Read): Promise<boolean> {
  const isNamed = !('name' in file) || String(file.name).toLowerCase().endsWith('.flac')
  return isNamed && String.fromCharCode(...(await read(0, 4))) === 'fLaC'
}

/** Judge a file as the server would, as far as its header and its peaks go; null where only the server can say. */
export async function judgeFile({ file, spec, length }: Judgeable): Promise<Judgement | null> {
  const read: Read = async (offset, count) => new Uint8Array(await file.slice(offset, offset + count).arrayBuffer())
  try {
    const isFlac = await startsAsFlac(file, read)
    const layout = isFlac ? await (await import('./flac')).readFlacLayout(read) : await readLayout(read, file.size)
    const peaks = isFlac ? null : await peaksOf(layout, read)
    return { isUnreadable: false, findings: check({ layout, peaks, spec, length }) }
  } catch (refusal) {
    if (refusal instanceof LeftToServer) return null
    if (!(refusal instanceof Unreadable)) throw refusal
    const { code, message, fix } = refusal
    return { isUnreadable: true, findings: [whole({ code, message, fix })] }
  }
}
