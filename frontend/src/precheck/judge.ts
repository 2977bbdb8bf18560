import { headerFix } from './autoFix'
import { check, otherThanAccepted, whole } from './checks'
import type { CueLength, Finding, SpecView } from './findings'
import { flacSlices, readFlacLayout } from './flac'
import { peaksOf, wavSlices } from './peaks'
import { LeftToServer, type Read, readLayout, Unreadable } from './wav'

/** A file to judge, and what by. */
export interface Judgeable {
  file: File
  spec: SpecView
  length: CueLength | null
}

export interface Judgement {
  /** The server would look no further into the file: it would find nothing else. */
  isUnreadable: boolean
  findings: Finding[]
}

/** Whether a FLAC is looked into: where it is accepted, or where another container would not reject it. */
function readsFlac({ accept: { containers }, levels }: SpecView): boolean {
  return containers === null || containers.includes('flac') || (levels.container ?? 'error') !== 'error'
}

const isFlac = async (file: File, read: Read): Promise<boolean> =>
  file.name.toLowerCase().endsWith('.flac') && String.fromCharCode(...(await read(0, 4))) === 'fLaC'

async function findingsOfFlac({ file, spec, length }: Judgeable, read: Read): Promise<Finding[]> {
  const layout = await readFlacLayout(read, file.size)
  return check({ layout, peaks: await peaksOf(layout, flacSlices(layout, read)), spec, length })
}

async function findingsOfWav({ file, spec, length }: Judgeable, read: Read): Promise<Finding[]> {
  const layout = await readLayout(read, file.size)
  return check({ layout, peaks: await peaksOf(layout, wavSlices(layout, read)), spec, length })
}

/** Judge a file as the server would, as far as its header and its peaks go; null where only the server can say. */
export async function judgeFile(judgeable: Judgeable): Promise<Judgement | null> {
  const { file, spec } = judgeable
  const read: Read = async (offset, count) => new Uint8Array(await file.slice(offset, offset + count).arrayBuffer())
  try {
    if (!(await isFlac(file, read))) return { isUnreadable: false, findings: await findingsOfWav(judgeable, read) }
    if (readsFlac(spec)) return { isUnreadable: false, findings: await findingsOfFlac(judgeable, read) }
    const finding = otherThanAccepted('flac', spec.accept.containers ?? [], 'container:flac')
    return { isUnreadable: true, findings: [whole(finding)] }
  } catch (refusal) {
    if (refusal instanceof LeftToServer) return null
    if (!(refusal instanceof Unreadable)) throw refusal
    const { code, message, fix } = refusal
    return { isUnreadable: true, findings: [whole({ code, message, fix, auto_fix: headerFix(code) })] }
  }
}
