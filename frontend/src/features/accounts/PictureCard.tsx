import { type DragEvent, useRef, useState } from 'react'

import type { Me } from '@/api/me'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Avatar } from '@/ui/Avatar'
import { bytes } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'

import classes from './Account.module.css'
import { useSavePicture } from './api'
import { CardProblem } from './CardProblem'

const MAX_BYTES = 10_000_000 // a little below the server's limit
const KINDS = ['image/png', 'image/jpeg', 'image/webp']

/** Why a file is not sent; the server looks at the bytes of what is. */
function problemOf(files: readonly File[]): { detail: string; fix: string } | undefined {
  const [file] = files
  if (files.length > 1) return { detail: `${files.length} files were dropped.`, fix: 'Drop one picture.' }
  if (file && file.size > MAX_BYTES) {
    const detail = `${file.name} has ${bytes(file.size)}. The limit is ${bytes(MAX_BYTES)}.`
    return { detail, fix: 'Make the picture smaller, then choose it again.' }
  }
  return undefined
}

/** The person's picture, as others see it beside the name: chosen, dropped, or taken away. */
export function PictureCard({ me }: { me: Me }) {
  const save = useSavePicture()
  const chooser = useRef<HTMLInputElement>(null)
  const [problem, setProblem] = useState<ReturnType<typeof problemOf>>()
  const [over, setOver] = useState(false)
  const { name, picture } = me.person
  const take = (files: readonly File[]) => {
    const [file] = files
    const fault = problemOf(files)
    setProblem(fault)
    save.reset()
    if (file && !fault) save.mutate(file, { onSuccess: () => showToast('This picture is shown beside your name now.') })
  }
  const drop = (event: DragEvent) => {
    event.preventDefault()
    setOver(false)
    take([...event.dataTransfer.files])
  }
  return (
    <Card
      aria-labelledby="picture-card"
      className={classes.dropped}
      data-over={over || undefined}
      onDragOver={(event) => {
        event.preventDefault()
        setOver(true)
      }}
      onDragLeave={() => setOver(false)}
      onDrop={drop}
    >
      <CardHead id="picture-card" title="Picture" note="shown beside your name" />
      <div className={`${classes.inside} items-start flex gap-4 ${classes.picture}`}>
        <Avatar name={name} picture={picture} large />
        <div className="grid gap-3 min-w-0">
          <p className="small mid">
            {picture ? 'Those who see your name see this picture.' : 'Without a picture, your initials are shown.'}{' '}
            Choose or drop a PNG, JPEG or WebP of up to {bytes(MAX_BYTES)}; its middle is kept.
          </p>
          {problem ? <ErrorBanner {...problem} /> : <CardProblem error={save.error} />}
          <p className="row">
            <Button variant="primary" disabled={save.isPending} onClick={() => chooser.current?.click()}>
              {picture ? 'Choose another' : 'Choose a picture'}
            </Button>
            {picture && (
              <Button
                disabled={save.isPending}
                onClick={() => {
                  setProblem(undefined)
                  save.mutate(null, { onSuccess: () => showToast('Your initials are shown again.') })
                }}
              >
                Remove picture
              </Button>
            )}
          </p>
          <input
            ref={chooser}
            type="file"
            hidden
            aria-label="Picture"
            accept={KINDS.join(',')}
            onChange={(event) => {
              take([...(event.target.files ?? [])])
              event.target.value = '' // the same file can be chosen again
            }}
          />
        </div>
      </div>
    </Card>
  )
}
